"""pardel.compat.triangle: `triangulate` and the functions of points do what those of the package `triangle` do."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pardel
import pardel.compat.triangle as tr

SQUARE = [[0, 0], [0, 1], [1, 1], [1, 0]]
SIDES = [[0, 1], [1, 2], [2, 3], [3, 0]]
FIVE = [[0, 0], [0, 1], [0.5, 0.5], [1, 1], [1, 0]]
INTEGERS = {"vertex_markers", "triangles", "segments", "segment_markers", "neighbors", "edges", "edge_markers"}


@pytest.fixture
def two():
    """Two squares side by side with attributes, markers and regions."""
    points = np.array([(0, 0), (1, 0), (2, 0), (2, 1), (1, 1), (0, 1)], dtype=float)
    return dict(vertices=points, vertex_attributes=points @ [[1, 2], [3, 4]],
                segments=[(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0), (1, 4)],
                segment_markers=[[0], [7], [0], [0], [3], [0], [0]],
                regions=[(0.5, 0.5, 10, 0.05), (1.5, 0.5, 20, -1)])


def checked(tri, made, **bounds):
    """The mesh is right for the domain, which has segments."""
    domain = pardel.Domain(tri["vertices"], tri["segments"], holes=tri.get("holes"))
    return pardel.check(domain, (made["vertices"], made["triangles"][:, :3]), **{"min_angle": 0, **bounds}).valid


def test_the_mesh_of_the_first_example_has_nine_vertices():
    made = tr.triangulate({"vertices": SQUARE}, "a0.2")
    assert sorted(made) == ["triangles", "vertex_markers", "vertices"]
    expected = {(0, 0), (0, 1), (1, 1), (1, 0), (0.5, 0.5), (0, 0.5), (0.5, 0), (1, 0.5), (0.5, 1)}
    assert set(map(tuple, made["vertices"])) == expected and made["vertices"][:4].tolist() == SQUARE
    assert made["vertex_markers"].tolist() == [[0 if tuple(p) == (0.5, 0.5) else 1] for p in made["vertices"]]
    assert len(made["triangles"]) == 8 and pardel.check(SQUARE, (made["vertices"], made["triangles"]), max_area=0.2)


def test_delaunay_returns_triangles_alone():
    triangles = tr.delaunay(FIVE)
    expected = {(0, 1, 2), (0, 2, 4), (2, 3, 4), (1, 2, 3)}
    assert set(map(tuple, np.sort(triangles, axis=1))) == expected and triangles.dtype == np.int32
    assert pardel.check(FIVE, (FIVE, triangles), min_angle=0, conforming=True)


def test_the_hull_is_clockwise_segments_that_begin_at_the_leftmost_point():
    assert tr.convex_hull(SQUARE).tolist() == [[3, 0], [2, 3], [1, 2], [0, 1]]


def test_the_diagram_has_points_edges_and_rays():
    points, edges, ray_origin, ray_direct = tr.voronoi(FIVE)
    assert sorted(points.tolist()) == [[0, 0.5], [0.5, 0], [0.5, 1], [1, 0.5]]
    assert edges.shape == (4, 2) and sorted(ray_origin.tolist()) == [0, 1, 2, 3]
    middle = np.array([0.5, 0.5])
    assert np.allclose(ray_direct, 2 * (points[ray_origin] - middle))
    assert np.allclose(np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1), np.sqrt(0.5))


@pytest.mark.parametrize("function", [tr.delaunay, tr.convex_hull, lambda points: tr.voronoi(points)[0]])
def test_equal_points_count_once(function):
    assert np.array_equal(function([*FIVE, *FIVE, [-0.0, 0.0]]), function(FIVE))


@pytest.mark.parametrize("points", [[], [[0, 0]], [[0, 0], [1, 0]]])
def test_fewer_than_three_points_are_a_value_error(points):
    for call in (tr.delaunay, tr.convex_hull, tr.voronoi, lambda p: tr.triangulate(dict(vertices=p))):
        with pytest.raises(ValueError, match="Input must have at least three vertices"):
            call(points)
    with pytest.raises(ValueError, match="Input must have at least three vertices"):
        tr.triangulate({}, "p")


def test_all_keys_have_their_shapes_and_dtypes(two):
    made = tr.triangulate(two, "pqAaen")
    columns = dict(vertices=2, vertex_attributes=2, vertex_markers=1, triangles=3, triangle_attributes=1, segments=2,
                   segment_markers=1, regions=4, neighbors=3, edges=2, edge_markers=1)
    assert {key: value.shape[1] for key, value in made.items()} == columns
    for key, value in made.items():
        assert value.dtype == (np.int32 if key in INTEGERS else np.float64), key
        assert value.flags.c_contiguous and value.flags.writeable and value.base is None, key


def test_empty_arrays_are_absent_keys(two):
    made = tr.triangulate(dict(vertices=two["vertices"], segments=two["segments"], holes=[], regions=[]), "pA")
    assert sorted(made) == ["segment_markers", "segments", "triangles", "vertex_markers", "vertices"]


def test_markers_are_those_of_segments_or_of_the_boundary(two):
    made = tr.triangulate(two, "pqa0.1e")
    x, y = made["vertices"].T
    on = {7: (y == 0) & (x > 1), 3: (y == 1) & (x < 1)}
    for marker, places in on.items():
        ends = made["edges"][made["edge_markers"].ravel() == marker]
        assert len(ends) and np.all(places[ends] | (x[ends] == 1))
    inner = (x == 1) & (y > 0) & (y < 1)
    assert inner.any() and not made["vertex_markers"].ravel()[inner].any()
    assert set(made["segment_markers"].ravel()) == {0, 1, 3, 7}


def test_attributes_of_new_vertices_are_interpolated(two):
    made = tr.triangulate(two, "pqa0.1")
    assert made["vertex_attributes"] == pytest.approx(made["vertices"] @ [[1, 2], [3, 4]])


def test_regions_give_attributes_and_areas(two):
    made = tr.triangulate(two, "pqAa")
    assert checked(two, made)
    p = made["vertices"][made["triangles"]]
    u, v = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
    area = (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2
    left = p.mean(axis=1)[:, 0] < 1
    assert np.array_equal(made["triangle_attributes"].ravel(), np.where(left, 10, 20))
    assert area[left].max() <= 0.05 < area[~left].max()
    assert made["regions"].tolist() == [list(region) for region in two["regions"]]


def test_areas_of_regions_count_only_with_a_and_attributes_only_with_upper_a(two):
    assert len(tr.triangulate(two, "pA")["triangles"]) == 4
    assert "triangle_attributes" not in tr.triangulate(two, "pa")


def test_triangles_outside_all_regions_have_the_attribute_zero(two):
    made = tr.triangulate({**two, "regions": [(0.5, 0.5, 10, 0)]}, "pA")
    assert sorted(made["triangle_attributes"].ravel()) == [0, 0, 10, 10]


def test_segments_holes_and_regions_count_only_with_p(two):
    made = tr.triangulate({**two, "holes": [(0.5, 0.5)]}, "qAa")
    assert sorted(made) == ["triangles", "vertex_attributes", "vertex_markers", "vertices"]
    assert len(made["triangles"]) == 4


def test_a_hole_is_cut_out_unless_the_switch_is_upper_o():
    box = tr.get_data("box")
    for opts, area in (("p", 8), ("pO", 9), ("pc", 8)):
        made = tr.triangulate(box, opts)
        assert pardel.Mesh(made["vertices"], made["triangles"]).area() == area
        assert made["holes"].tolist() == [[1.5, 1.5]]


def test_the_hull_of_an_open_polyline_is_meshed_with_c():
    open_line = dict(vertices=[*SQUARE, [0.5, 0.5]], segments=[[0, 4]])
    made = tr.triangulate(open_line, "pc")
    assert sorted(map(sorted, made["segments"].tolist())) == [[0, 1], [0, 3], [0, 4], [1, 2], [2, 3]]
    with pytest.raises(pardel.InvalidInput, match="No outline is closed"):
        tr.triangulate(open_line, "p")


def test_p_without_segments_is_refused():
    with pytest.raises(pardel.UsageError, match="switch p, but tri has no segments"):
        tr.triangulate(dict(vertices=SQUARE), "p")


def test_equal_vertices_stay_in_the_list_and_j_removes_them():
    points = [*SQUARE, [1, 1], [9, 9]]
    tri = dict(vertices=points, segments=SIDES, vertex_markers=[1, 2, 3, 4, 5, 6])
    kept, removed = tr.triangulate(tri, "p"), tr.triangulate(tri, "pj")
    assert kept["vertices"].tolist() == points and kept["vertex_markers"].ravel().tolist() == [1, 2, 3, 4, 5, 6]
    assert sorted(set(kept["triangles"].ravel())) == [0, 1, 2, 3]
    assert removed["vertices"].tolist() == SQUARE and removed["vertex_markers"].ravel().tolist() == [1, 2, 3, 4]


def test_crossing_segments_get_a_common_vertex_behind_the_given_ones():
    made = tr.triangulate(dict(vertices=SQUARE, segments=[*SIDES, [0, 2], [1, 3]],
                               vertex_attributes=[[0], [1], [2], [1]]), "pe")
    assert made["vertices"].tolist() == [*SQUARE, [0.5, 0.5]] and len(made["triangles"]) == 4
    assert made["vertex_attributes"].ravel().tolist() == [0, 1, 2, 1, 1]
    assert checked(dict(vertices=made["vertices"], segments=made["segments"]), made)


def test_vertices_that_nearly_coincide_stay_apart():
    near = np.nextafter(0.5, 1)
    made = tr.triangulate(dict(vertices=[*SQUARE, [0.5, 0.5], [near, 0.5], [1, 1]], segments=SIDES), "p")
    assert sorted(set(made["triangles"].ravel())) == [0, 1, 2, 3, 4, 5]


def test_two_regions_in_one_face_mean_the_last_one():
    made = tr.triangulate(dict(vertices=SQUARE, segments=SIDES, regions=[(0.5, 0.4, 1, 0), (0.5, 0.5, 2, 0)]), "pA")
    assert set(made["triangle_attributes"].ravel()) == {2}


@given(st.lists(st.tuples(st.integers(0, 5), st.integers(0, 5)), min_size=3, max_size=30))
def test_points_in_any_position_are_triangulated_or_refused(points):
    try:
        made = tr.triangulate(dict(vertices=points), "en")
    except pardel.InvalidInput as error:
        assert np.linalg.matrix_rank(np.array(points) - points[0]) < 2, error
        return
    assert made["vertices"].tolist() == [list(map(float, point)) for point in points]
    used = np.unique(made["triangles"])
    assert len(used) == len(set(points))
    assert len(used) - len(made["edges"]) + len(made["triangles"]) == 1
    assert np.count_nonzero(made["neighbors"] == -1) == np.count_nonzero(made["edge_markers"] == 1)
