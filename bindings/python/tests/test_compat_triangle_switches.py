"""pardel.compat.triangle: each switch, the refinement of a mesh, and what is refused."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pardel
import pardel.compat.triangle as tr
from pardel.compat.triangle.switches import parsed

SQUARE = dict(vertices=[[0, 0], [1, 0], [1, 1], [0, 1]], segments=[[0, 1], [1, 2], [2, 3], [3, 0]])
DOMAIN = pardel.Domain(SQUARE["vertices"], SQUARE["segments"])


def areas(made):
    p = made["vertices"][made["triangles"][:, :3]]
    u, v = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
    return (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2


@pytest.mark.parametrize("opts, bounds", [
    ("pq", dict(min_angle=20)), ("pq31.5a.01", dict(min_angle=31.5, max_area=0.01)), ("pa0.01", dict(max_area=0.01)),
    ("qa0.02", dict(min_angle=20, max_area=0.02)), ("pD", dict(conforming=True)), ("pq34", dict(min_angle=34)),
    ("pqa0.01D", dict(min_angle=20, max_area=0.01, conforming=True)),
    ("pq a0.05 -C", dict(min_angle=20, max_area=0.05))])
def test_the_bounds_of_the_switches_hold(opts, bounds):
    made = tr.triangulate(SQUARE, opts)
    assert pardel.check(DOMAIN, (made["vertices"], made["triangles"]), **{"min_angle": 0, **bounds}).valid


def test_segments_are_split_for_a_conforming_mesh_alone():
    inner = [[0.1, 0.5], [0.9, 0.5], [0.5, 0.51], [0.5, 0.49]]
    tri = dict(vertices=[*SQUARE["vertices"], *inner], segments=[*SQUARE["segments"], [4, 5]])
    domain = pardel.Domain(tri["vertices"], tri["segments"])
    for opts, is_conforming in (("p", False), ("pD", True)):
        made = tr.triangulate(tri, opts)
        certificate = pardel.check(domain, (made["vertices"], made["triangles"]), min_angle=0, conforming=True)
        assert certificate.valid == is_conforming


@pytest.mark.parametrize("opts", ["pq30a0.01C", "pa0.01YC", "pcDC"])
def test_upper_c_asks_the_checker(opts, monkeypatch):
    tr.triangulate(SQUARE, opts)
    wrong = pardel.check(DOMAIN, pardel.Mesh(DOMAIN.points, [(0, 1, 2)]), min_angle=0)
    monkeypatch.setattr("pardel.checking.check", lambda *_, **__: wrong)
    tr.triangulate(SQUARE, opts.replace("C", ""))
    with pytest.raises(pardel.InternalError, match="the mesh is wrong: uncovered_domain"):
        tr.triangulate(SQUARE, opts)


def test_a_small_area_in_the_notation_of_python_is_one_number():
    assert parsed(f"pqa{1e-05}e").max_area == 1e-05 and parsed(f"pqa{1e-05}e").edges
    assert parsed("a0.1e").max_area == 0.1 and parsed("a0.1e").edges


def test_both_forms_of_a_may_be_given():
    found = parsed("pa0.5a")
    assert found.max_area == 0.5 and found.areas


@pytest.mark.parametrize("switch, absent", [("B", {"vertex_markers", "segment_markers", "edge_markers"}),
                                            ("P", {"segments", "segment_markers"}), ("E", {"triangles"}),
                                            ("N", {"vertices", "vertex_markers"})])
def test_a_switch_leaves_out_keys(switch, absent):
    assert set(tr.triangulate(SQUARE, "pe")) - set(tr.triangulate(SQUARE, "pe" + switch)) == absent


def test_switches_of_triangles_algorithms_files_and_texts_change_nothing():
    plain = tr.triangulate(SQUARE, "pqa0.1")
    for switch in ("i", "F", "l", "s", "X", "V", "VV", "Q", "z", "v", "I", "g", "o"):
        made = tr.triangulate(SQUARE, "pqa0.1" + switch)
        assert set(made) == set(plain) and all(np.array_equal(made[key], plain[key]) for key in plain)


@pytest.mark.parametrize("switches, whole", [("Y", [0, 1, 2, 3]), ("YY", [0, 1, 2, 3, 4])])
def test_segments_of_the_boundary_or_all_stay_whole(switches, whole):
    tri = dict(vertices=SQUARE["vertices"], segments=[*SQUARE["segments"], [0, 2]])
    made = tr.triangulate(tri, "pqa0.01" + switches)
    edges = {frozenset(edge) for edge in made["segments"].tolist()}
    assert [k for k, segment in enumerate(tri["segments"]) if frozenset(segment) in edges] == whole


def test_s_limits_the_number_of_new_vertices():
    for limit in ("S0", "S"):
        assert len(tr.triangulate(SQUARE, "pqa0.001" + limit)["vertices"]) == 4
    assert len(tr.triangulate(SQUARE, "pqa0.001S25")["vertices"]) == 29


def test_edges_and_neighbours_fit_the_triangles():
    made = tr.triangulate(SQUARE, "pqa0.01en")
    triangles, neighbors = made["triangles"], made["neighbors"]
    for k in range(3):
        opposite = np.sort(triangles[:, [(k + 1) % 3, (k + 2) % 3]], axis=1)
        inside = neighbors[:, k] >= 0
        assert all(set(side) <= set(triangles[other]) for side, other in zip(opposite[inside], neighbors[inside, k]))
    assert len(made["vertices"]) - len(made["edges"]) + len(triangles) == 1
    assert made["edge_markers"].sum() == np.count_nonzero(neighbors < 0) == len(made["segments"])


def test_six_nodes_are_corners_and_the_middles_opposite_them():
    tri = dict(SQUARE, vertex_attributes=[[0], [1], [2], [1]], segment_markers=[5, 6, 7, 8])
    made = tr.triangulate(tri, "pqa0.1o2e")
    p, t = made["vertices"], made["triangles"]
    assert t.shape[1] == 6 and t.dtype == np.int32 and len(np.unique(t)) == len(p) == t.max() + 1
    for k in range(3):
        assert np.array_equal(p[t[:, 3 + k]], (p[t[:, (k + 1) % 3]] + p[t[:, (k + 2) % 3]]) / 2)
    assert made["vertex_attributes"].ravel() == pytest.approx(p.sum(axis=1))
    first = t[:, :3].max() + 1
    bottom = (p[:, 1] == 0) & (np.arange(len(p)) >= first)
    assert bottom.any() and set(made["vertex_markers"][bottom].ravel()) == {5}
    assert made["edges"].max() < first


@given(st.text(alphabet="pqaADcenjBPNEOYSo2C0.1", max_size=8))
def test_any_switches_give_a_mesh_or_a_clear_error(opts):
    opts += "S50"
    tri = dict(SQUARE, regions=[(0.5, 0.5, 3, 0.1)], triangles=[[0, 1, 2], [0, 2, 3]])
    try:
        made = tr.triangulate(tri, opts)
    except pardel.UsageError as error:
        assert "opts" in str(error)
        return
    if "vertices" in made and "triangles" in made:
        assert areas(made).sum() == pytest.approx(1)


@pytest.mark.parametrize("opts, message", [
    ("pu", "the switch u is not supported: a test of triangles"), ("w", "the switch w is not supported"),
    ("pk", "'k' is not a switch of Triangle"), ("a0", "must be greater than 0"),
    ("pa1.2.3", "'1.2.3' after the switch a"), ("q.", "'.' after the switch q is not a number"),
    ("q50S5", "at most 45 degrees"), ("r", "tri has no triangles to refine"),
    ("rC", "the switch C is not supported beside r"), (7, "opts is 7; a string"),
    ("pq44.9a0.01", "the smallest angle of 44.9 degrees needs more than")])
def test_what_cannot_be_done_is_an_error_that_names_the_switch(opts, message):
    with pytest.raises(pardel.UsageError, match=message):
        tr.triangulate(SQUARE, opts)


@pytest.mark.parametrize("change, message", [
    (dict(points=[]), "tri has the unknown key 'points'"), (dict(segments=[[0, 9]]), r"segments\[0\] has the point 9"),
    (dict(segment_markers=[1]), r"segment_markers has the shape \(1,\); \(4,\)"),
    (dict(holes=[[1, 2, 3]]), r"holes has the shape \(1, 3\)"), (dict(regions=[[0, 0, 1]]), r"regions has the shape"),
    (dict(vertex_attributes=[[1.0]]), r"vertex_attributes has the shape \(1, 1\); \(4, k\)"),
    (dict(vertices=[[0, 0], [1, 0], [1, float("nan")], [0, 1]]), "Point 2 at .* is not a finite number")])
def test_a_wrong_array_is_an_error_that_names_its_key(change, message):
    with pytest.raises(ValueError, match=message):
        tr.triangulate({**SQUARE, **change}, "pA")


def test_a_mesh_is_refined_with_its_segments_markers_and_attributes():
    tri = dict(SQUARE, segments=[*SQUARE["segments"], [0, 2]], segment_markers=[1, 2, 3, 4, 5],
               regions=[(0.7, 0.2, 10, 0), (0.2, 0.7, 20, 0)], vertex_attributes=[[0], [1], [2], [1]])
    coarse = tr.triangulate(tri, "pA")
    made = tr.triangulate(coarse, "rpq30a0.02")
    domain = pardel.Domain(tri["vertices"], tri["segments"])
    assert pardel.check(domain, (made["vertices"], made["triangles"]), min_angle=30, max_area=0.02)
    assert set(made["segment_markers"].ravel()) == {1, 2, 3, 4, 5}
    middles = made["vertices"][made["triangles"]].mean(axis=1)
    assert np.array_equal(made["triangle_attributes"].ravel(), np.where(middles[:, 0] > middles[:, 1], 10, 20))
    assert made["vertex_attributes"].ravel() == pytest.approx(made["vertices"].sum(axis=1))
    on_diagonal = made["vertices"][made["segments"][made["segment_markers"].ravel() == 5]]
    assert np.array_equal(on_diagonal[..., 0], on_diagonal[..., 1]) and len(on_diagonal) > 1


def test_several_attributes_of_triangles_stay_together():
    coarse = dict(SQUARE, triangles=[[0, 1, 2], [0, 2, 3]], segments=[[0, 2]], triangle_attributes=[[1, 5], [2, 7]])
    made = tr.triangulate(coarse, "rpa0.01")
    assert set(map(tuple, made["triangle_attributes"])) == {(1, 5), (2, 7)}


def test_refinement_keeps_to_the_largest_area_of_each_triangle():
    coarse = dict(SQUARE, triangles=[[0, 1, 2], [0, 2, 3]], triangle_max_area=[[0.01], [-1]])
    made = tr.triangulate(coarse, "ra")
    middles = made["vertices"][made["triangles"]].mean(axis=1)
    assert areas(made)[middles[:, 0] > middles[:, 1] + 0.1].max() <= 0.01 < areas(made).max()
    with pytest.raises(pardel.UsageError, match="tri has no triangle_max_area"):
        tr.triangulate({key: coarse[key] for key in ("vertices", "triangles")}, "ra")


def test_refinement_without_bounds_keeps_a_delaunay_mesh():
    coarse = tr.triangulate(SQUARE, "pqa0.05")
    made = tr.triangulate(coarse, "rp")
    assert np.array_equal(made["vertices"], coarse["vertices"])
    assert {frozenset(t) for t in made["triangles"].tolist()} == {frozenset(t) for t in coarse["triangles"].tolist()}


def test_six_nodes_are_refined_by_their_corners():
    six = tr.triangulate(SQUARE, "po2")
    made = tr.triangulate({key: six[key] for key in ("vertices", "triangles")}, "rja0.1")
    assert pardel.check(DOMAIN, (made["vertices"], made["triangles"]), min_angle=0, max_area=0.1)


def test_a_segment_that_is_no_edge_of_the_mesh_is_named():
    coarse = dict(SQUARE, triangles=[[0, 1, 2], [0, 2, 3]], segments=[[0, 1], [1, 3]])
    with pytest.raises(pardel.UsageError, match=r"segments\[1\] is \(1, 3\), which is no edge of the triangles"):
        tr.triangulate(coarse, "rpq")


def test_precision_that_does_not_suffice_is_an_error():
    tiny = dict(vertices=[[2**40, 2**40], [2**40 + 2**-12, 2**40], [2**40, 2**40 + 2**-12]])
    with pytest.raises(pardel.InvalidInput, match="miss a bound, because no double splits them"):
        tr.triangulate(tiny, "a0.000000001")
