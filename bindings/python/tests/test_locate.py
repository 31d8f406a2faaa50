"""Mesh.locate and Mesh.interpolate, compared with the definition and with SciPy."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pardel

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]


@pytest.fixture
def two():
    return pardel.Mesh(SQUARE, [(0, 1, 2), (0, 2, 3)])


def first_around(mesh, place):
    """By definition. Doubles are exact here: all coordinates are small multiples of a half."""
    start = mesh.points[mesh.triangles]
    ahead, towards = np.roll(start, -1, axis=1) - start, np.array(place) - start
    is_left = ahead[..., 0] * towards[..., 1] >= ahead[..., 1] * towards[..., 0]
    return next(iter(np.flatnonzero(is_left.all(axis=1))), -1)


small = st.integers(-8, 8)
halves = st.tuples(*[st.integers(-18, 18).map(lambda k: k / 2)] * 2)
point_sets = st.lists(st.tuples(small, small), min_size=3, max_size=40, unique=True)


@st.composite
def torn_meshes(draw):
    """Delaunay triangulations that lack some triangles, the others in any order: with holes, in several parts."""
    points = draw(point_sets)
    if pardel.validate(points):
        points = [*SQUARE, (3, 5)]
    whole = pardel.delaunay(points)
    kept = draw(st.permutations(range(len(whole.triangles))))[draw(st.integers(0, len(whole.triangles) // 2)):]
    return pardel.Mesh(whole.points, whole.triangles[kept])


@given(torn_meshes(), st.lists(halves, min_size=1, max_size=30))
def test_any_point_is_located_as_the_definition_says(mesh, places):
    places = [*places, *mesh.points.tolist()]
    assert mesh.locate(places).tolist() == [first_around(mesh, place) for place in places]


@given(torn_meshes(), st.lists(halves, min_size=1, max_size=30), st.floats(-9, 9), st.floats(-9, 9), st.floats(-9, 9))
def test_linear_functions_are_reproduced(mesh, places, a, b, c):
    values = a * mesh.points[:, 0] + b * mesh.points[:, 1] + c
    found = mesh.interpolate(values, places)
    x, y = np.transpose(places)
    inside = mesh.locate(places) >= 0
    assert np.allclose(found[inside], (a * x + b * y + c)[inside], rtol=0, atol=1e-12)
    assert np.isnan(found[~inside]).all()


@given(torn_meshes(), st.lists(st.floats(allow_nan=False), min_size=40, max_size=40))
def test_any_value_at_a_vertex_is_reproduced_exactly(mesh, values):
    values = np.array(values)[:len(mesh.points)]
    used = np.unique(mesh.triangles)
    # Another triangle may contain a vertex only if it has the vertex as a corner, so the values are its own.
    assert np.array_equal(mesh.interpolate(values, mesh.points[used]), values[used])


@given(torn_meshes(), st.lists(halves, min_size=1, max_size=30),
       st.lists(st.floats(-1e6, 1e6), min_size=40, max_size=40))
def test_interpolated_values_lie_between_those_at_the_corners(mesh, places, values):
    values = np.array(values)[:len(mesh.points)]
    triangle = mesh.locate(places)
    inside = triangle >= 0
    corners = values[mesh.triangles[triangle[inside]]]
    found = mesh.interpolate(values, np.array(places))[inside]
    assert (corners.min(axis=1, initial=np.inf) <= found).all()
    assert (found <= corners.max(axis=1, initial=-np.inf)).all()


def test_an_edge_and_a_vertex_belong_to_the_triangle_with_the_smallest_index(two):
    assert two.locate([(0.5, 0.5), (0, 0), (1, 1), (0, 1)]).tolist() == [0, 0, 0, 1]
    assert pardel.Mesh(SQUARE, [(0, 2, 3), (0, 1, 2)]).locate([(0.5, 0.5), (0, 1)]).tolist() == [0, 0]


def test_places_outside_and_places_that_are_not_finite_get_minus_one(two):
    places = [(2, 2), (np.nan, 0.5), (0.5, np.inf), (-np.inf, 0), (1e308, 0.5), (np.nextafter(1, 2), 0.5)]
    assert two.locate(places).tolist() == [-1] * 6
    assert two.interpolate([1, 2, 3, 4], places, outside=-5).tolist() == [-5] * 6


def test_a_hole_is_outside(plate):
    made = pardel.mesh(plate, max_area=0.1)
    assert made.locate([(2, 2), (0.5, 0.5)])[0] == -1 and made.locate([(0.5, 0.5)])[0] >= 0


def test_the_result_has_the_types_that_are_promised(two):
    assert two.locate(np.empty((0, 2))).shape == (0,) and two.locate([]).dtype == np.int32
    assert two.interpolate([1, 2, 3, 4], [(0.5, 0.5)]).shape == (1,)
    assert two.interpolate(np.ones((4, 3), np.float32), [(0.5, 0.5)] * 2).shape == (2, 3)
    assert two.interpolate(np.ones((4, 1)), [(0.5, 0.5)]).shape == (1, 1)
    assert two.interpolate(np.ones((4, 0)), [(0.5, 0.5)]).shape == (1, 0)
    assert two.interpolate([1, 2, 3, 4], []).dtype == np.float64


@pytest.mark.parametrize("dtype", ["f2", "f4", "f8", ">f8", "i1", "u8", "?", "g"])
def test_values_may_have_any_real_dtype(two, dtype):
    values = np.array([0, 1, 1, 0], dtype)
    assert two.interpolate(values, [(0.75, 0.25), (0.25, 0.75)]).tolist() == [0.75, 0.25]
    columns = np.stack([values, np.roll(values, 2)], axis=1)[:, ::-1]
    assert two.interpolate(columns, [(0.75, 0.25)]).tolist() == [[0.25, 0.75]]


WRONG = {
    "points of one dimension": (lambda mesh: mesh.locate([0.5, 0.5]), r"points has the shape \(2,\); \(n, 2\)"),
    "points of text": (lambda mesh: mesh.locate([("a", "b")]), "points has the dtype <U1"),
    "too few values": (lambda mesh: mesh.interpolate([1, 2], [(0, 0)]),
                       r"values has the shape \(2,\); \(4,\) or \(4, k\)"),
    "values of three dimensions": (lambda mesh: mesh.interpolate(np.ones((4, 1, 1)), [(0, 0)]), "values has the shape"),
    "complex values": (lambda mesh: mesh.interpolate(np.ones(4, complex), [(0, 0)]), "values has the dtype complex128"),
    "values in rows of different lengths": (lambda mesh: mesh.interpolate([(1,), (1, 2), (), ()], [(0, 0)]),
                                            "values is not an array"),
    "text outside": (lambda mesh: mesh.interpolate([1, 2, 3, 4], [(0, 0)], outside="no"), "outside is 'no'"),
    "negative threads": (lambda mesh: mesh.locate([(0, 0)], threads=-1), "threads is -1"),
}


@pytest.mark.parametrize("what", WRONG)
def test_a_wrong_argument_is_named(two, what, capfd):
    call, message = WRONG[what]
    with pytest.raises(pardel.UsageError, match=message):
        call(two)
    assert capfd.readouterr() == ("", "")


INVALID = {
    "a clockwise triangle": (SQUARE, [(0, 1, 2), (0, 3, 2)],
                             r"triangle 1 of the mesh \(vertices 0, 3, 2\) is clockwise"),
    "a point that is not finite": ([(0, 0), (1, np.nan), (1, 1)], [(0, 1, 2)], r"has a corner at \(1, nan\)"),
    "a point that is not there": (SQUARE, [(0, 1, 7)], "index that is not the index of a point"),
}


@pytest.mark.parametrize("what", INVALID)
def test_a_mesh_in_which_nothing_can_be_located_is_refused(what):
    points, triangles, message = INVALID[what]
    with pytest.raises(pardel.InvalidInput, match=message):
        pardel.Mesh(points, triangles).locate([(0, 0)])


def test_a_point_that_no_triangle_uses_may_be_anything():
    mesh = pardel.Mesh([*SQUARE, (np.nan, np.inf)], [(0, 1, 2), (0, 2, 3)])
    assert mesh.locate([(0.5, 0.25)]).tolist() == [0]


def test_the_number_of_threads_changes_nothing(plate):
    made = pardel.mesh(plate, max_area=1e-3)
    places = np.random.default_rng(3).random((50_000, 2)) * 5 - 0.5
    values = np.sin(made.points)
    for threads in (2, 5):
        assert np.array_equal(made.locate(places, threads=1), made.locate(places, threads=threads))
        assert np.array_equal(made.interpolate(values, places, threads=1),
                              made.interpolate(values, places, threads=threads), equal_nan=True)


def test_triangles_are_those_that_scipy_finds(random_points):
    spatial = pytest.importorskip("scipy.spatial")
    theirs = spatial.Delaunay(random_points)
    ours = pardel.Mesh(theirs.points, theirs.simplices)
    places = np.random.default_rng(4).random((5000, 2)) * 1.2 - 0.1
    assert np.array_equal(ours.locate(places), theirs.find_simplex(places, tol=0))


def test_one_mesh_is_searched_by_many_threads_at_once(plate):
    import threading

    made = pardel.mesh(plate, max_area=1e-4)
    places = made.points[made.triangles].mean(axis=1)
    found = []
    threads = [threading.Thread(target=lambda: found.append(made.locate(places))) for _ in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 6 and all(np.array_equal(each, np.arange(len(places))) for each in found)
