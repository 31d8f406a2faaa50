"""Meshes and domains are pickled and copied whole."""

import copy
import multiprocessing
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pardel

ARRAYS = ("points", "triangles", "neighbors", "edges", "edge_markers", "segments", "segment_markers", "segment_ids",
          "point_markers", "regions", "region_attributes", "attributes")
WAYS = {f"pickle {protocol}": lambda value, protocol=protocol: pickle.loads(pickle.dumps(value, protocol))
        for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1)}
WAYS.update({"copy": copy.copy, "deepcopy": copy.deepcopy})


def assert_same(one, other):
    for name in ARRAYS:
        a, b = getattr(one, name), getattr(other, name)
        assert a.dtype == b.dtype and a.shape == b.shape and np.array_equal(a, b, equal_nan=True), name
        assert not b.flags.writeable
    assert one.digest == other.digest and one.domain == other.domain


def rich_mesh():
    points = [(0, 0), (1, 0), (2, 0), (2, 1), (1, 1), (0, 1)]
    segments = [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0), (1, 4)]
    return pardel.mesh(points, segments, regions=[(0.5, 0.5, 10, 0.01), (1.5, 0.5, 20, 0)],
                       markers=[1, 1, 2, 1, 1, 3, 0], attributes=np.arange(12).reshape(6, 2),
                       point_markers=[5, 0, 0, 7, 0, 0], max_vertices=60)


@pytest.mark.parametrize("way", WAYS)
def test_a_mesh_keeps_all_arrays_its_domain_and_its_report(way):
    mesh = rich_mesh()
    other = WAYS[way](mesh)
    assert other is not mesh
    assert_same(mesh, other)
    assert list(other.report.exempt) == list(mesh.report.exempt) and len(mesh.report.exempt) > 0
    assert other.report.gaps == mesh.report.gaps and other.report.refine_seconds == mesh.report.refine_seconds


@pytest.mark.parametrize("way", WAYS)
def test_a_domain_stays_equal(way, plate):
    domain = pardel.Domain(plate.points, plate.segments, holes=plate.holes, regions=[(0.5, 0.5, 7, 0.1)],
                           markers=np.arange(8), point_markers=np.arange(8), attributes=np.eye(8))
    assert WAYS[way](domain) == domain


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("suffix", ["vtu", "msh", "2dm", "node"])
def test_a_mesh_of_a_file_is_written_as_before(way, suffix, tmp_path):
    rich_mesh().save(tmp_path / f"made.{suffix}")
    read = pardel.read(tmp_path / f"made.{suffix}")
    other = WAYS[way](read)
    assert_same(read, other)
    assert other.report is None and other.domain is None
    read.save(tmp_path / "first.vtu")
    other.save(tmp_path / "second.vtu")
    assert (tmp_path / "first.vtu").read_bytes() == (tmp_path / "second.vtu").read_bytes()


def test_fields_of_a_file_are_kept(tmp_path):
    meshio = pytest.importorskip("meshio")
    data = np.array([1.0, 2, 3, np.nan])
    meshio.Mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [("triangle", [(0, 1, 2), (0, 2, 3)])],
                point_data={"height": data},
                cell_data={"flow": [[(1.0, 2.0, 3.0), (4, 5, 6)]]}).write(tmp_path / "in.vtu")
    read = pardel.read(tmp_path / "in.vtu")
    pickle.loads(pickle.dumps(read)).save(tmp_path / "out.vtu")
    out = meshio.read(tmp_path / "out.vtu")
    assert np.array_equal(out.point_data["height"].ravel(), data, equal_nan=True)
    assert out.cell_data["flow"][0].tolist() == [[1, 2, 3], [4, 5, 6]]


def test_a_mesh_that_only_the_checker_can_use_is_pickled_too():
    broken = pardel.Mesh([(0, 0), (1, 0), (0, 1)], [(0, 1, 9), (0, 1, 2)])
    other = pickle.loads(pickle.dumps(broken))
    assert np.array_equal(other.triangles, broken.triangles) and np.array_equal(other.neighbors, broken.neighbors)


def test_a_copy_shares_the_memory(square):
    mesh = pardel.mesh(square, max_area=0.01)
    assert np.shares_memory(copy.copy(mesh).points, mesh.points)
    assert np.shares_memory(copy.deepcopy({"mesh": mesh})["mesh"].triangles, mesh.triangles)


def test_a_copy_has_the_attributes_that_the_caller_added(square):
    class Named(pardel.Mesh):
        pass

    mesh = Named([(0, 0), (1, 0), (0, 1)], [(0, 1, 2)])
    mesh.names = ["a"]
    shallow, deep = copy.copy(mesh), copy.deepcopy(mesh)
    assert type(shallow) is type(deep) is Named and deep.names == ["a"]
    assert shallow.names is mesh.names and deep.names is not mesh.names


def test_the_memory_of_a_copy_outlives_the_original(square):
    mesh = pardel.mesh(square, max_area=0.01)
    kept, other = mesh.points.copy(), copy.copy(mesh)
    del mesh
    assert np.array_equal(other.points, kept)


def refined_digest(mesh):
    return pardel.refine(mesh, max_area=0.01).digest


def test_meshes_travel_between_processes(square):
    meshes = [pardel.mesh(square, max_area=area) for area in (0.1, 0.05, 0.02)]
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        assert pool.map(refined_digest, meshes) == [refined_digest(mesh) for mesh in meshes]


def test_exceptions_keep_their_problems(crossing):
    with pytest.raises(pardel.InvalidInput) as caught:
        pardel.mesh(crossing)
    other = pickle.loads(pickle.dumps(caught.value))
    assert type(other) is pardel.InvalidInput and other.problems == caught.value.problems


def test_certificates_and_reports_are_pickled(plate):
    made = pardel.mesh(plate)
    certificate = pardel.check(plate, made)
    assert pickle.loads(pickle.dumps(certificate)) == certificate
    assert pickle.loads(pickle.dumps(made.report)).exempt_counts == made.report.exempt_counts


def test_a_damaged_pickle_is_refused(square):
    function, (cls, form, state, domain, rest) = pardel.mesh(square).__reduce__()
    with pytest.raises(pardel.UsageError, match="pickled by a later version of pardel, in form 99"):
        function(cls, 99, state, domain, rest)
    for name, wrong in (("regions", [0]), ("point_markers", [1]), ("attributes_per_point", 3), ("origin", [1]),
                        ("fields", [("f", True, 1, [1.0], 0.0)])):
        with pytest.raises(pardel.InvalidInput, match="arrays that do not belong together"):
            function(cls, form, {**state, name: wrong}, domain, rest)


small = st.integers(-8, 8)


@given(st.lists(st.tuples(small, small), min_size=3, max_size=30, unique=True), st.booleans())
def test_any_triangulation_is_the_same_after_pickling(points, is_refined):
    if pardel.validate(points):
        return
    made = pardel.mesh(points) if is_refined else pardel.delaunay(points)
    assert_same(made, pickle.loads(pickle.dumps(made)))


@pytest.mark.parametrize("way", WAYS)
def test_a_raster_stays_the_same(way):
    raster = pardel.Raster([[0.1, 0.3, np.inf], [0.7, np.nan, 0.2]], extent=(0.1, 0.7, -0.3, 1 / 3))
    other = WAYS[way](raster)
    assert other.extent == raster.extent and np.array_equal(other.values, raster.values, equal_nan=True)


def sources_of_each_kind(folder):
    """A name, and places in a domain with a marker 2 and a region with the attribute 7."""
    rules = folder / "rules.sources"
    rules.write_text("point 0.5 0.5 0.01\nmarker 2 0.05\nregion 7 0.1\n")
    field = {"type": "Polygon", "coordinates": [[(0.2, 0.2), (0.7, 0.2), (0.7, 0.6), (0.2, 0.2)]]}
    wood = {"type": "Polygon", "coordinates": [[(0.4, 0.1), (0.9, 0.1), (0.9, 0.5), (0.4, 0.1)]]}  # they cross
    yield "arrays", pardel.Sources(points=[(0.5, 0.5, 0.01)], lines=[(0, 0, 1, 1, 0.03, 0.05)], markers={2: 0.1},
                                   regions={7: 0.2})
    yield "file", pardel.Sources.read(rules)
    yield "shapes", pardel.Sources.of([field, wood, {"type": "Point", "coordinates": (0.1, 0.9)}], [0.02, 0.03, 0.01])


@pytest.mark.parametrize("way", ["pickle 2", f"pickle {pickle.HIGHEST_PROTOCOL}", "copy", "deepcopy"])
def test_sources_of_each_kind_make_the_same_mesh(way, square, tmp_path):
    domain = pardel.Domain(square.points, square.segments, markers=square.markers, regions=[(0.5, 0.5, 7)])
    for kind, sources in sources_of_each_kind(tmp_path):
        other = WAYS[way](WAYS[way](sources))
        assert len(other) == len(sources) > 2
        meshes = [pardel.mesh(domain, sources=each, grading=0.3) for each in (sources, other)]
        assert meshes[0].digest == meshes[1].digest, kind
    with pytest.raises(pardel.InvalidInput, match="rules.sources:2: no "):  # the line is kept
        pardel.mesh([(0, 0), (1, 0), (1, 1)], sources=WAYS[way](pardel.Sources.read(tmp_path / "rules.sources")),
                    grading=0.3)


def test_a_raster_of_a_later_form_is_refused():
    core = pardel.Raster([[1]], (0, 1, 0, 1))._core
    with pytest.raises(pardel.UsageError, match="the raster was pickled by a later version of pardel, in form 2"):
        type(core).__new__(type(core)).__setstate__((2, *core.__getstate__()[1:]))
