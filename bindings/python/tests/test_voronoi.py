"""pardel.voronoi: the dual of the Delaunay triangulation."""

import doctest
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pardel
import pardel.diagram

coordinate = st.integers(-6, 6)
lattice = st.lists(st.tuples(coordinate, coordinate), min_size=3, max_size=25, unique=True)


def diagram_of(points):
    try:
        return pardel.voronoi(points)
    except pardel.InvalidInput as error:
        assert {problem.kind for problem in error.problems} == {"all_points_collinear"}
        return None


def exact_circumcentre(corners):
    (x, y), (ax, ay), (bx, by) = [[Fraction(float(c)) for c in corner] for corner in corners]
    ax, ay, bx, by = ax - x, ay - y, bx - x, by - y
    a, b, twice = ax * ax + ay * ay, bx * bx + by * by, 2 * (ax * by - ay * bx)
    return x + (by * a - ay * b) / twice, y + (ax * b - bx * a) / twice


def test_the_examples_of_docstrings_are_true():
    failed, tried = doctest.testmod(pardel.diagram)
    assert tried > 0 and failed == 0


@given(lattice)
def test_vertices_are_the_rounded_circumcentres(points):
    diagram = diagram_of(points)
    if diagram is None:
        return
    for corners, vertex in zip(diagram.delaunay.triangles, diagram.vertices):
        exact = exact_circumcentre(diagram.delaunay.points[corners])
        assert vertex == pytest.approx([float(c) for c in exact], rel=1e-12, abs=1e-12)


@given(lattice)
def test_no_site_is_nearer_to_a_vertex_than_its_own(points):
    diagram = diagram_of(points)
    if diagram is None:
        return
    away = np.linalg.norm(diagram.vertices[:, None] - diagram.delaunay.points[None], axis=2)
    own = away[np.arange(len(away))[:, None], diagram.delaunay.triangles]
    assert np.allclose(own, own[:, :1], rtol=1e-9) and np.all(away.min(axis=1) >= own[:, 0] * (1 - 1e-9))


@given(lattice)
def test_an_edge_has_no_length_exactly_if_its_circumcentres_are_one_point(points):
    diagram = diagram_of(points)
    if diagram is None:
        return
    centres = [exact_circumcentre(diagram.delaunay.points[corners]) for corners in diagram.delaunay.triangles]
    assert diagram.has_length.tolist() == [centres[a] != centres[b] for a, b in diagram.edges.tolist()]
    same = diagram.edges[~diagram.has_length]
    assert np.array_equal(diagram.vertices[same[:, 0]], diagram.vertices[same[:, 1]])


@given(lattice)
def test_each_edge_of_the_triangulation_has_its_edge_or_ray(points):
    diagram = diagram_of(points)
    if diagram is None:
        return
    sites = np.sort(np.concatenate([diagram.edge_sites, diagram.ray_sites]), axis=1)
    expected = np.sort(diagram.delaunay.edges, axis=1)
    assert sorted(map(tuple, sites)) == sorted(map(tuple, expected))
    triangles = [set(corners) for corners in diagram.delaunay.triangles.tolist()]
    for (a, b), ends in zip(diagram.edges.tolist(), diagram.edge_sites.tolist()):
        assert triangles[a] & triangles[b] == set(ends)


@given(lattice)
def test_rays_leave_at_right_angles_and_have_no_site_nearer(points):
    diagram = diagram_of(points)
    if diagram is None:
        return
    a, b = (diagram.delaunay.points[diagram.ray_sites[:, k]] for k in (0, 1))
    assert np.all(np.einsum("ij,ij->i", b - a, diagram.ray_directions) == 0)
    assert np.array_equal(np.linalg.norm(b - a, axis=1), np.linalg.norm(diagram.ray_directions, axis=1))
    far = diagram.vertices[diagram.ray_origins] + 1000 * diagram.ray_directions
    away = np.linalg.norm(far[:, None] - diagram.delaunay.points[None], axis=2)
    assert np.all(away.min(axis=1) >= np.linalg.norm(far - a, axis=1) * (1 - 1e-9))


def test_cocircular_sites_share_one_place():
    angle = 2 * np.pi * np.arange(4) / 4
    diagram = pardel.voronoi(np.round(np.stack([np.cos(angle), np.sin(angle)], axis=1)))
    assert len(diagram.vertices) == 2 and not diagram.vertices.any()
    assert diagram.has_length.tolist() == [False] and len(diagram.ray_origins) == 4


def test_the_corners_of_rectangles_are_cocircular_and_share_one_place():
    x, y = np.random.default_rng(3).random((2, 9)).cumsum(axis=1)
    diagram = pardel.voronoi(np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2))
    same = diagram.edges[~diagram.has_length]
    assert len(same) == 64 and np.array_equal(diagram.vertices[same[:, 0]], diagram.vertices[same[:, 1]])


def test_a_needle_has_an_accurate_circumcentre():
    points = np.array([(0.1, 0.3), (0.9, 0.8), (0.9 - 3e-8, 0.8 + 5e-8)])
    (vertex,), exact = pardel.voronoi(points).vertices, exact_circumcentre(points)
    assert vertex.tolist() == pytest.approx([float(c) for c in exact], rel=1e-14)


def test_a_nearly_cocircular_edge_has_length():
    diagram = pardel.voronoi([(1, 0), (0, 1), (-1, 0), (0, np.nextafter(-1, -2))])
    assert diagram.has_length.tolist() == [True]


def test_all_points_of_a_circle_give_one_place():
    triples = [(3, 4), (4, 3), (5, 0), (0, 5)]
    points = sorted({(sx * x, sy * y) for x, y in triples for sx in (1, -1) for sy in (1, -1)})
    diagram = pardel.voronoi(points)
    assert len(points) == 12 and not diagram.has_length.any() and not diagram.vertices.any()


@pytest.mark.parametrize("flat", [[(0, 0), (1, 1e-17), (2, 0), (1, 5)],
                                  [(0, 0), (1, 1 / 3), (3, 1 - 2**-50), (1, 5)]])
def test_a_flat_triangle_has_an_accurate_circumcentre(flat):
    points = np.array(flat)
    diagram = pardel.voronoi(points)
    for corners, vertex in zip(diagram.delaunay.triangles, diagram.vertices):
        assert vertex.tolist() == pytest.approx([float(c) for c in exact_circumcentre(points[corners])], rel=1e-9)
    assert np.abs(diagram.vertices).max() > 1e14


def test_the_largest_coordinates_and_the_flattest_triangle_overflow_nothing():
    big, small = 2.0**200, 2.0**-140
    with np.errstate(all="raise"):
        diagram = pardel.voronoi([(-big, 0), (0, -small), (big, 0)])
    assert diagram.vertices.tolist() == [[0, 2.0**539]]


def test_a_large_grid_has_square_cells():
    side = np.arange(60.0)
    diagram = pardel.voronoi(np.stack(np.meshgrid(side, side), axis=-1).reshape(-1, 2))
    assert np.count_nonzero(diagram.has_length) == 2 * 59 * 58 and len(diagram.ray_origins) == 4 * 59
    ends = diagram.vertices[diagram.edges[diagram.has_length]]
    assert np.allclose(np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1), 1)


def test_equal_points_are_refused_by_name():
    with pytest.raises(pardel.InvalidInput, match="Points 1 and 3 are both at"):
        pardel.voronoi([(0, 0), (1, 0), (0, 1), (1, 0)])


def test_a_wrong_shape_is_named():
    with pytest.raises(pardel.UsageError, match=r"points has the shape \(1, 3\)"):
        pardel.voronoi([(0, 0, 0)])


def test_a_diagram_shows_its_size():
    assert repr(pardel.voronoi([(0, 0), (1, 0), (0, 1)])) == "Voronoi(1 vertices, 0 edges, 3 rays)"
