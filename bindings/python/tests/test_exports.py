"""Meshes for meshio, SciPy and matplotlib."""

import sys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pardel
from test_pickling import rich_mesh

small = st.integers(-8, 8)
point_sets = st.lists(st.tuples(small, small), min_size=3, max_size=40, unique=True)


def test_save_writes_what_write_writes(tmp_path, plate):
    made = pardel.mesh(plate)
    for suffix, options in (("vtu", {}), ("msh", {"as_text": True}), ("vtu", {"second_order": True})):
        made.save(tmp_path / f"a.{suffix}", **options)
        pardel.write(tmp_path / f"b.{suffix}", made, **options)
        assert (tmp_path / f"a.{suffix}").read_bytes() == (tmp_path / f"b.{suffix}").read_bytes()


def test_meshio_gets_triangles_lines_markers_and_regions():
    pytest.importorskip("meshio")
    mesh = rich_mesh()
    theirs = mesh.to_meshio()
    assert [block.type for block in theirs.cells] == ["triangle", "line"]
    assert np.array_equal(theirs.cells_dict["triangle"], mesh.triangles)
    assert np.array_equal(theirs.cells_dict["line"], mesh.segments)
    assert np.array_equal(theirs.cell_data["marker"][1], mesh.segment_markers)
    assert not theirs.cell_data["marker"][0].any()
    assert set(theirs.cell_data["region"][0]) == {10, 20}
    assert np.array_equal(theirs.point_data["attributes"], mesh.attributes)
    assert np.array_equal(theirs.point_data["marker"], mesh.point_markers)
    assert theirs.points.flags.c_contiguous and theirs.cells_dict["triangle"].flags.c_contiguous


def test_a_mesh_of_meshio_is_checked_and_read_again(plate, tmp_path):
    pytest.importorskip("meshio")
    made = pardel.mesh(plate, max_area=0.1)
    assert pardel.check(plate, made.to_meshio(), max_area=0.1)
    made.to_meshio().write(tmp_path / "made.vtu")
    read = pardel.read(tmp_path / "made.vtu")
    assert pardel.check(plate, read, max_area=0.1)
    assert np.array_equal(np.sort(read.segment_markers), np.sort(made.segment_markers))


def test_meshio_gets_the_fields_of_a_file(tmp_path):
    meshio = pytest.importorskip("meshio")
    first = meshio.Mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [("triangle", [(0, 1, 2), (0, 2, 3)])],
                        point_data={"height": [1.0, 2, 3, 4]}, cell_data={"flow": [[(1.0, 2.0, 3.0), (4, 5, 6)]]})
    first.write(tmp_path / "in.vtu")
    again = pardel.read(tmp_path / "in.vtu").to_meshio()
    assert again.point_data["height"].tolist() == [1, 2, 3, 4]
    assert again.cell_data["flow"][0].tolist() == [[1, 2, 3], [4, 5, 6]]


def test_fields_of_triangles_have_no_values_on_lines(tmp_path):
    meshio = pytest.importorskip("meshio")
    cells = [("triangle", [(0, 1, 2), (0, 2, 3)]), ("line", [(0, 1), (1, 2), (2, 3), (3, 0)])]
    meshio.Mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], cells,
                cell_data={"flow": [[1.0, 2.0], [3.0, 4.0, 5.0, 6.0]]}).write(tmp_path / "in.vtu")
    again = pardel.read(tmp_path / "in.vtu").to_meshio()
    assert [block.type for block in again.cells] == ["triangle", "line"]
    assert again.cell_data["flow"][0].tolist() == [1, 2] and np.isnan(again.cell_data["flow"][1]).all()


def test_triangles_in_no_region_have_the_attribute_0_for_meshio():
    pytest.importorskip("meshio")
    points = [(0, 0), (1, 0), (2, 0), (2, 1), (1, 1), (0, 1)]
    mesh = pardel.mesh(points, [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0), (1, 4)], regions=[(0.5, 0.5, 10, 0)])
    region = mesh.to_meshio().cell_data["region"][0]
    assert np.array_equal(region == 10, mesh.points[mesh.triangles][:, :, 0].mean(axis=1) < 1)
    assert set(region) == {0, 10}


def test_a_mesh_without_segments_has_no_lines_for_meshio():
    pytest.importorskip("meshio")
    mesh = pardel.Mesh([(0, 0), (1, 0), (0, 1)], [(0, 1, 2)])
    assert [block.type for block in mesh.to_meshio().cells] == ["triangle"]


def test_matplotlib_gets_a_triangulation(plate):
    pytest.importorskip("matplotlib")
    mesh = pardel.mesh(plate, max_area=0.1)
    theirs = mesh.to_matplotlib()
    assert np.array_equal(theirs.triangles, mesh.triangles) and np.array_equal(theirs.x, mesh.points[:, 0])
    places = np.random.default_rng(5).random((500, 2)) * 5 - 0.5
    assert np.array_equal(theirs.get_trifinder()(*places.T), mesh.locate(places))


def test_the_adjacency_is_that_of_the_edges(plate):
    pytest.importorskip("scipy")
    mesh = pardel.mesh(plate, max_area=0.1)
    matrix = mesh.adjacency()
    assert matrix.shape == (len(mesh.points),) * 2 and matrix.nnz == 2 * len(mesh.edges) and matrix.has_sorted_indices
    assert (matrix != matrix.T).nnz == 0 and set(matrix.data) == {1}
    dense = np.zeros(matrix.shape, int)
    dense[tuple(mesh.edges.T)] = dense[tuple(mesh.edges[:, ::-1].T)] = 1
    assert np.array_equal(matrix.toarray(), dense)


def test_lengths_of_edges_give_shortest_paths(square):
    csgraph = pytest.importorskip("scipy.sparse.csgraph")
    mesh = pardel.mesh(square, max_edge=0.1)
    distance = csgraph.dijkstra(mesh.adjacency(lengths=True), indices=0)
    straight = np.hypot(*mesh.points.T)
    assert np.all(distance >= straight - 1e-12) and np.all(distance <= 1.5 * straight + 1e-12)


def test_the_parts_of_a_mesh_are_found_with_scipy():
    csgraph = pytest.importorskip("scipy.sparse.csgraph")
    mesh = pardel.Mesh([(0, 0), (1, 0), (0, 1), (5, 5), (6, 5), (5, 6)], [(0, 1, 2), (3, 4, 5)])
    assert csgraph.connected_components(mesh.adjacency())[0] == 2


SAME = ("points", "simplices", "neighbors", "transform", "coplanar", "min_bound", "max_bound", "npoints", "nsimplex",
        "ndim")


@given(point_sets)
def test_simplices_are_what_scipy_computes(points):
    spatial = pytest.importorskip("scipy.spatial")
    if pardel.validate(points):
        return
    theirs = spatial.Delaunay(points)
    if len(theirs.coplanar):
        return
    ours = pardel.Mesh(theirs.points, theirs.simplices).to_scipy()
    for name in SAME:
        assert np.allclose(getattr(ours, name), getattr(theirs, name)), name
    assert {frozenset(edge) for edge in ours.convex_hull.tolist()} == {
        frozenset(edge) for edge in theirs.convex_hull.tolist()}
    starts, ends = theirs.vertex_neighbor_vertices
    for vertex in range(len(points)):
        mine = ours.vertex_neighbor_vertices[1][slice(*ours.vertex_neighbor_vertices[0][vertex:vertex + 2])]
        assert sorted(ends[starts[vertex]:starts[vertex + 1]]) == mine.tolist()
        assert vertex in ours.simplices[ours.vertex_to_simplex[vertex]]


@given(point_sets, st.lists(st.tuples(st.floats(-9, 9), st.floats(-9, 9)), min_size=1, max_size=10))
def test_the_transform_gives_barycentric_coordinates(points, places):
    if pardel.validate(points):
        return
    simplices = pardel.delaunay(points).to_scipy()
    places = np.array(places)
    found = simplices.find_simplex(places)
    inside = found >= 0
    rows = simplices.transform[found[inside]]
    first = np.einsum("nij,nj->ni", rows[:, :2], places[inside] - rows[:, 2])
    weights = np.concatenate([first, 1 - first.sum(axis=1, keepdims=True)], axis=1)
    assert (weights > -1e-9).all()
    corners = simplices.points[simplices.simplices[found[inside]]]
    assert np.allclose(np.einsum("nk,nkj->nj", weights, corners), places[inside])


def test_find_simplex_takes_points_of_any_shape(square):
    simplices = pardel.mesh(square).to_scipy()
    assert simplices.find_simplex((0.5, 0.25)).shape == () and simplices.find_simplex((0.5, 0.25)) >= 0
    assert simplices.find_simplex(np.full((3, 4, 2), 0.5), bruteforce=True, tol=1e-6).shape == (3, 4)
    with pytest.raises(pardel.UsageError, match=r"xi has the shape \(3,\); \(..., 2\) is needed"):
        simplices.find_simplex([1, 2, 3])


def test_a_flat_triangle_has_no_transform_and_an_unused_point_no_simplex():
    simplices = pardel.Mesh([(0, 0), (1, 0), (2, 0), (0, 1), (9, 9)], [(0, 1, 2), (0, 1, 3)]).to_scipy()
    assert np.isnan(simplices.transform[0]).sum() == 4 and np.isfinite(simplices.transform[1]).all()
    assert simplices.vertex_to_simplex.tolist() == [0, 0, 0, 1, -1]
    assert repr(simplices) == "Simplices(5 points, 2 simplices)"


def test_the_arrays_of_simplices_are_contiguous_and_cannot_be_written(square):
    simplices = pardel.mesh(square).to_scipy()
    for name in ("points", "simplices", "neighbors", "transform", "convex_hull", "vertex_to_simplex"):
        array = getattr(simplices, name)
        assert array.flags.c_contiguous and not array.flags.writeable


def test_an_empty_mesh_is_exported():
    empty = pardel.Mesh([], [])
    simplices = empty.to_scipy()
    assert simplices.find_simplex([(0, 0)]).tolist() == [-1] and simplices.convex_hull.shape == (0, 2)
    assert simplices.transform.shape == (0, 3, 2) and simplices.vertex_neighbor_vertices[0].tolist() == [0]


@pytest.mark.parametrize("method, package", [("to_meshio", "meshio"), ("to_matplotlib", "matplotlib"),
                                             ("adjacency", "scipy")])
def test_a_missing_package_is_named(square, monkeypatch, method, package):
    for name in [name for name in sys.modules if name.split(".")[0] == package]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(pardel.UsageError, match=rf"{method}\(\) needs the package {package}, which is not installed"):
        getattr(pardel.mesh(square), method)()
