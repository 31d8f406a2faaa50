"""Properties of the package on domains and arrays that Hypothesis draws."""

import math
import tempfile
from pathlib import Path

import numpy as np
from hypothesis import assume, example, given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

import pardel

small_whole = st.integers(-8, 8)
places = st.tuples(small_whole, small_whole)
point_sets = st.lists(places, min_size=3, max_size=40, unique=True)


@st.composite
def stars(draw):
    """A polygon around a centre, with corners at drawn angles and distances."""
    steps = draw(st.lists(st.integers(1, 20), min_size=3, max_size=24))
    radii = draw(st.lists(st.floats(0.2, 5), min_size=len(steps), max_size=len(steps)))
    angles = 2 * math.pi * np.cumsum(steps) / sum(steps)
    assume(2 * max(steps) < sum(steps))  # the centre is inside
    return np.stack([np.cos(angles), np.sin(angles)], axis=1) * np.array(radii)[:, None]


def is_meshable(points):
    return not any(problem.kind == "all_points_collinear" for problem in pardel.validate(points))


@given(stars(), st.sampled_from([0, 10, 20.7, 30]), st.one_of(st.none(), st.floats(0.01, 1)))
def test_any_polygon_that_is_drawn_is_meshed_and_certified(corners, min_angle, max_area):
    domain = pardel.polygon(corners)
    made = pardel.mesh(domain, min_angle=min_angle, max_area=max_area)
    assert made.report.goal_met
    assert pardel.check(domain, made, min_angle=min_angle, max_area=max_area)


@given(stars(), stars(), st.floats(0.05, 0.9))
def test_any_polygon_with_a_hole_is_meshed_and_certified(outer, inner, scale):
    hole = inner * (scale * 0.2 / 5 * math.cos(math.pi / 4))
    domain = pardel.polygon(outer, hole)
    assume(not pardel.validate(domain))
    assert pardel.check(domain, pardel.mesh(domain))


@given(stars())
def test_the_area_of_a_mesh_is_that_of_its_polygon(corners):
    x, y = corners.T
    area = 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))
    assert math.isclose(pardel.mesh(pardel.polygon(corners)).area(), area, rel_tol=1e-9)


@given(st.lists(places, min_size=4, max_size=14, unique=True))
@example([(0, 0), (2, 2), (0, 2), (2, 0)])
def test_any_closed_line_is_repaired_and_certified_or_refused(corners):
    domain = pardel.polygon(corners)
    try:
        made = pardel.mesh(domain, repair=True)
    except pardel.InvalidInput:
        assert pardel.validate(domain)
        return
    assert pardel.validate(made.domain) == () and pardel.check(made.domain, made)


@given(st.lists(places, min_size=3, max_size=10),
       st.lists(st.tuples(st.integers(0, 9), st.integers(0, 9)), max_size=12))
def test_repairing_a_repaired_domain_changes_nothing(points, pairs):
    segments = [pair for pair in pairs if max(pair) < len(points)]
    try:
        repaired = pardel.repair(points, segments, convex_hull=True)
    except pardel.InvalidInput:
        return
    assert pardel.repair(repaired.domain, convex_hull=repaired.convex_hull).domain == repaired.domain


@given(stars(), st.integers(2, 6), st.floats(0.01, 0.5))
def test_the_number_of_threads_changes_no_bit_of_any_mesh(corners, threads, max_edge):
    domain = pardel.polygon(corners)
    one, many = (pardel.mesh(domain, max_edge=max_edge, threads=count) for count in (1, threads))
    assert np.array_equal(one.points, many.points) and np.array_equal(one.triangles, many.triangles)


@given(point_sets)
def test_the_delaunay_triangulation_of_any_points_is_certified(points):
    assume(is_meshable(points))
    assert pardel.check(points, pardel.delaunay(points), min_angle=0, conforming=True)


@given(point_sets)
def test_the_convex_hull_of_any_points_contains_them(points):
    assume(is_meshable(points))
    order = pardel.convex_hull(points)
    hull = np.array(points)[order]
    ahead = np.roll(hull, -1, axis=0) - hull
    for point in points:
        towards = np.array(point) - hull
        assert np.all(ahead[:, 0] * towards[:, 1] - ahead[:, 1] * towards[:, 0] >= 0)
    assert tuple(hull[0]) == min(points) and len(set(order.tolist())) == len(order)


@given(stars(), st.floats(0.01, 0.3), st.booleans())
def test_a_refined_mesh_is_certified_for_the_same_domain(corners, max_area, as_arrays):
    domain = pardel.polygon(corners)
    coarse = pardel.mesh(domain)
    refined = pardel.refine((coarse.points, coarse.triangles) if as_arrays else coarse, max_area=max_area)
    assert pardel.check(domain, refined, max_area=max_area)
    assert np.array_equal(refined.points[:len(coarse.points)], coarse.points)


@given(stars(), st.sampled_from(["vtu", "msh", "off", "vtk", "2dm", "node"]))
def test_any_mesh_is_the_same_after_it_was_written_and_read(corners, suffix):
    made = pardel.mesh(pardel.polygon(corners))
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / f"mesh.{suffix}"
        pardel.write(file, made)
        read = pardel.read(file)
    assert np.array_equal(read.points, made.points) and len(read.triangles) == len(made.triangles)


@given(stars(), st.lists(st.floats(0.1, 2), min_size=24, max_size=24))
def test_any_lengths_at_the_points_are_kept(corners, lengths):
    domain = pardel.polygon(corners)
    size = np.array(lengths[:len(corners)])
    assert pardel.check(domain, pardel.mesh(domain, size=size), size=size)


@given(stars(), st.floats(0.05, 1), st.floats(0, 0.5))
def test_functions_of_arrays_and_of_numbers_make_the_same_mesh(corners, least, slope):
    domain = pardel.polygon(corners)
    arrays_made = pardel.mesh(domain, size=lambda at: least + slope * np.abs(at[:, 0]))
    assert arrays_made.digest == pardel.mesh(domain, size=lambda x, y: least + slope * abs(x)).digest


@given(arrays.arrays(np.float64, st.tuples(st.integers(0, 6), st.just(2)), elements=st.floats(width=64)),
       arrays.arrays(np.int64, st.tuples(st.integers(0, 6), st.just(3)), elements=st.integers(-2, 7)))
def test_the_checker_takes_any_arrays(points, triangles):
    certificate = pardel.check([(0, 0), (1, 0), (0, 1)], (points, triangles))
    assert certificate.valid == (not certificate.violation_counts)


@given(arrays.arrays(np.float64, st.tuples(st.integers(0, 6), st.just(2)), elements=st.floats(width=64)),
       arrays.arrays(np.int64, st.tuples(st.integers(0, 6), st.just(2)), elements=st.integers(0, 5)))
def test_any_arrays_are_meshed_or_refused_with_problems(points, segments):
    try:
        made = pardel.mesh(points, segments, max_vertices=1000)
    except pardel.UsageError:
        assert segments.max() >= len(points)
    except pardel.InvalidInput as refused:
        assert refused.problems
    else:
        assert len(made.triangles) > 0


@given(st.one_of(st.none(), st.text(), st.lists(st.text(), max_size=3), st.floats(),
                 st.dictionaries(st.text(), st.text()),
                 arrays.arrays(st.sampled_from(["U3", "c8", "M8[s]", "b1"]), arrays.array_shapes())))
def test_what_are_no_points_is_refused_with_an_exception_of_the_package(value):
    try:
        pardel.Domain(value)
    except pardel.Error as error:
        assert "points" in str(error)
    else:
        assert np.size(value) == 0 or np.asarray(value).dtype == bool
