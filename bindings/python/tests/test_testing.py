"""pardel.testing.certify: right meshers are certified, and ten kinds of mistakes are found and shrunk."""

import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import strategies as st
from wrong_meshers import (crosses_triangles, doubles_a_triangle, drops_a_hole, flips_an_edge,
                           has_a_point_far_outside, ignores_a_segment, leaves_a_gap, misses_the_angle, moves_a_point,
                           right, turns_a_triangle)

import pardel
import pardel.testing
from pardel.testing import NotCertified, certify, replay


def test_the_mesher_of_pardel_is_certified_on_all_families():
    summary = certify(right, max_examples=50)
    assert summary.domains == {family: 50 for family in pardel.testing.FAMILIES}
    assert f"certified: 400 domains of 8 families, {summary.triangles} triangles" == str(summary)
    assert summary.triangles > 400


def test_the_delaunay_triangulation_of_scipy_is_certified_on_point_sets():
    spatial = pytest.importorskip("scipy.spatial")
    summary = certify(lambda points, *_: (points, spatial.Delaunay(points).simplices), families="points", min_angle=0)
    assert summary.domains == {"points": 100}


def test_the_delaunay_triangulation_of_scipy_is_refused_where_a_polygon_is_not_convex():
    spatial = pytest.importorskip("scipy.spatial")
    with pytest.raises(NotCertified) as caught:
        certify(lambda points, *_: (points, spatial.Delaunay(points).simplices), families="polygons", min_angle=0)
    assert len(caught.value.domain.points) == 4 and "covered_exterior" in caught.value.certificate.violation_counts


MISTAKES = [  # the mesher, families, violations of which one is found, and the most points of the shrunk domain
    (drops_a_hole, ["holes"], {"covered_exterior"}, 6),
    (ignores_a_segment, ["regions", "cracks"], {"broken_segment"}, 8),
    (moves_a_point, None, {"missing_input_vertex"}, 4),
    (flips_an_edge, None, {"not_delaunay"}, 5),
    (leaves_a_gap, None, {"uncovered_domain", "broken_segment", "chain_off_segment"}, 6),
    (turns_a_triangle, None, {"degenerate_triangle"}, 4),
    (doubles_a_triangle, None, {"duplicate_triangle"}, 4),
    (misses_the_angle, None, {"small_angle"}, 6),
    (has_a_point_far_outside, None, {"covered_exterior"}, 4),
    (crosses_triangles, None, {"overlap", "degenerate_triangle", "covered_exterior"}, 4),
]


@pytest.mark.parametrize("mesher, families, kinds, most", MISTAKES, ids=[row[0].__name__ for row in MISTAKES])
def test_a_mistake_is_found_shrunk_and_repeated_by_one_line(mesher, families, kinds, most):
    with pytest.raises(NotCertified) as caught:
        certify(mesher, families=families)
    found = caught.value
    assert kinds & set(found.certificate.violation_counts)
    assert len(found.domain.points) <= most
    assert np.abs(found.domain.points).max() <= 36 and np.all(found.domain.points == np.rint(found.domain.points))
    assert found.code in str(found) and "\n" not in found.code and mesher.__name__ in found.code
    with pytest.raises(NotCertified) as again:
        eval(found.code)
    assert again.value.reason == found.reason and again.value.code == found.code
    assert replay(right, found.domain.points, found.domain.segments, found.domain.holes).valid


def test_an_exception_of_the_mesher_is_found_with_its_domain():
    def refuses_holes(points, segments, holes, min_angle):
        if len(holes) > 0:
            raise IndexError("no room")
        return right(points, segments, holes, min_angle)

    with pytest.raises(NotCertified, match="the mesher raised IndexError: no room") as caught:
        certify(refuses_holes, families=["polygons", "holes"])
    assert isinstance(caught.value.__cause__, IndexError) and len(caught.value.domain.holes) == 1
    assert caught.value.family == "holes" and caught.value.certificate is None


@pytest.mark.parametrize("returned, text", [
    (None, "is needed; this is a NoneType"), ((1, 2, 3), "this is a tuple of 3"),
    (([(0, 0)], [(0, 1)]), r"triangles has the shape \(1, 2\); \(m, 3\) is needed"),
    (([(0, 0)], [(0.5, 1, 2)]), "triangles has the dtype float64; integers are needed")])
def test_a_result_that_is_no_mesh_is_named(returned, text):
    with pytest.raises(NotCertified, match=f"the mesher returned no mesh: .*{text}"):
        certify(lambda *_: returned, max_examples=5)


def test_a_mesher_may_return_a_mesh_and_change_its_arguments():
    def careless(points, segments, holes, min_angle):
        made = pardel.mesh(points, segments, holes=holes, min_angle=min_angle)
        points[:], segments[:], holes[:] = 0, 0, 0
        return made

    assert certify(careless, max_examples=10)


def test_a_mesher_that_changes_its_mind_is_found():
    calls = []

    def fails_once(*arguments):
        calls.append(arguments)
        return ([], []) if len(calls) == 3 else right(*arguments)

    with pytest.raises(NotCertified, match="another run on the same domain gave another result"):
        certify(fails_once)


def test_ignored_kinds_do_not_count():
    assert certify(flips_an_edge, ignore=["not_delaunay", "small_angle"], families=["polygons"], max_examples=20)
    with pytest.raises(NotCertified) as caught:
        certify(leaves_a_gap, ignore=["not_delaunay"], families=["polygons"])
    assert "ignore=['not_delaunay']" in caught.value.code


def test_equal_seeds_find_equal_domains():
    def drawn(seed):
        seen = []
        certify(lambda *arguments: seen.append(arguments[0]) or right(*arguments), seed=seed, max_examples=10)
        return np.concatenate(seen).tolist()

    assert drawn(1) == drawn(1) != drawn(2)


def test_families_of_ones_own_stand_beside_the_named_ones():
    squares = st.integers(1, 9).map(lambda a: pardel.polygon([(0, 0), (a, 0), (a, a), (0, a)]))
    assert certify(right, families=["points", squares], max_examples=5).domains == {"points": 5, "families[1]": 5}
    with pytest.raises(NotCertified) as caught:
        certify(turns_a_triangle, families=squares)
    assert caught.value.domain.points.max() == 1


def test_an_invalid_domain_of_a_family_is_an_error_of_the_family():
    crossing = pardel.Domain([(0, 0), (1, 1), (0, 1), (1, 0)], [(0, 1), (1, 2), (2, 3), (3, 0)])
    with pytest.raises(pardel.InvalidInput) as caught:
        certify(lambda points, *_: (points, [(0, 1, 2)]), families=st.just(crossing))
    assert caught.value.problems


def test_regions_with_areas_of_a_family_of_ones_own_are_no_bounds():
    capped = pardel.Domain([(0, 0), (1, 0), (0, 1)], [(0, 1), (1, 2), (2, 0)], regions=[(0.2, 0.2, 1, 1e-3)])
    assert certify(right, families=st.just(capped), max_examples=1)


@pytest.mark.parametrize("arguments, text", [
    (dict(mesher=7), "mesher is a int; a function"), (dict(families=["cubes"]), r"families\[0\] is 'cubes'; the famil"),
    (dict(families=[]), "families is empty"), (dict(max_examples=0), "max_examples is 0; at least 1 is needed"),
    (dict(max_examples=-1), "max_examples is -1"), (dict(min_angle="x"), "min_angle is 'x'; a number is needed"),
    (dict(min_angle=60), "min_angle is 60; a number from 0 to below 60"), (dict(seed="x"), "seed is 'x'"),
    (dict(ignore="overlap"), "ignore is 'overlap'"),
    (dict(families=st.just(7)), "a strategy of families drew a int; a Domain is needed")])
def test_wrong_arguments_are_named(arguments, text):
    with pytest.raises(pardel.UsageError, match=text):
        certify(**{"mesher": right, "max_examples": 2, **arguments})


def test_an_invalid_domain_cannot_be_replayed():
    with pytest.raises(pardel.InvalidInput):
        replay(lambda points, *_: (points, [(0, 1, 2)]), [(0, 0), (1, 1), (0, 1), (1, 0)],
               [(0, 1), (1, 2), (2, 3), (3, 0)])


def test_nothing_is_printed(capfd):
    with pytest.raises(NotCertified):
        certify(turns_a_triangle, families="polygons")
    assert capfd.readouterr() == ("", "")


def test_every_name_has_a_docstring_and_is_on_the_page():
    page = (Path(os.environ.get("PARDEL_SOURCE", Path(__file__).resolve().parents[3])) / "docs/python.md").read_text()
    for name in pardel.testing.__all__:
        assert isinstance(getattr(pardel.testing, name), tuple) or getattr(pardel.testing, name).__doc__
        assert re.search(rf"\b{name}\b", page), name


def test_only_this_part_needs_hypothesis():
    program = ("import sys; sys.modules['hypothesis'] = None; import pardel; print(pardel.__version__)\n"
               "try:\n    import pardel.testing\nexcept ImportError as error:\n    print(error)")
    ended = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert ended.stdout.splitlines() == [pardel.__version__, "pardel.testing needs the package hypothesis (pip install "
                                         "hypothesis, or the Debian package python3-hypothesis)"]
    imported = "import sys, pardel; print('hypothesis' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", imported], capture_output=True, text=True).stdout == "False\n"
