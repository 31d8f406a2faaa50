"""Scripts for MeshPy run after a change of one import, and their meshes are right."""

import doctest
import importlib
import inspect
import os
import pickle
import runpy
from pathlib import Path

import numpy as np
import pytest

import pardel
from pardel.compat.meshpy import triangle

SCRIPTS = Path(__file__).parent / "scripts_meshpy"


class Own(Exception):
    """An exception that only these tests know."""


def domain_of(info):
    """What a MeshInfo describes; like Triangle, pardel merges equal points and splits crossing segments."""
    holes = np.array(info.holes) if len(info.holes) else None
    given = pardel.Domain(np.array(info.points), np.array(info.facets), holes=holes)
    return pardel.repair(given, snap=0).domain if pardel.validate(given) else given


def certificate(info, mesh, **bounds):
    bounds.setdefault("min_angle", 20)
    corners = np.array(mesh.elements)[:, :3]
    return pardel.check(domain_of(info), (np.array(mesh.points)[:corners.max() + 1], corners), **bounds)


def square(**facets):
    info = triangle.MeshInfo()
    info.set_points([(0, 0), (1, 0), (1, 1), (0, 1)])
    info.set_facets([(0, 1), (1, 2), (2, 3), (3, 0)], **facets)
    return info


# The script, the bounds that its mesh must keep, the least and the largest number of elements, and what else is true.
CASES = {
    "square_with_a_hole": (dict(min_angle=30, max_area=0.05), 240, 480,
                           lambda v: set(v["mesh"].facet_markers) == {1}),
    "disk_refined_at_a_point": (
        dict(refine_if=lambda c, area: area > 0.0005 + 0.02 * ((c[:, 0].mean() - 1)**2 + c[:, 1].mean()**2)), 350, 800,
        lambda v: len(v["mesh"].facets) >= 60),
    "outlines_that_repeat_a_point": (
        dict(max_area=0.1), 250, 700, lambda v: len(v["inner_nodes"]) >= 12 and len(v["outer_nodes"]) >= 12),
    "heat_in_a_square": (dict(min_angle=28, max_area=2e-3), 500, 1000,
                         lambda v: abs(v["temperature"].max() - 0.0737) < 2e-3),
    "two_materials": (dict(max_area=0.05), 540, 1200, lambda v: len(v["fine"]) >= 500 and len(v["coarse"]) >= 40
                      and len(v["fine"]) + len(v["coarse"]) == len(v["mesh"].elements)),
    "quadratic_elements": (dict(max_area=0.02), 100, 250, lambda v: v["farthest"] < 1e-15),
    "refine_every_tenth_element": (dict(max_area=0.1), 400, 3000, lambda v: set(v["mesh"].facet_markers) == {5, 6}),
    "periodic_strip": (dict(max_area=0.04), 90, 300,
                       lambda v: np.allclose(v["left"], v["right"]) and len(v["mesh"].facets) == 34),
    "l_shape_for_gnuplot": (dict(max_area=0.1), 30, 120, lambda v: len(v["blocks"]) == len(v["mesh"].elements)),
    "kept_in_a_pickle": (dict(max_area=0.005), 100, 300,
                         lambda v: list(v["mesh"].points)[:14] == list(v["coarse"].points)[:14]
                         and list(v["mesh"].point_markers)[:3] == [11, 12, 13]),
    "cylinder_in_a_channel": (dict(), 300, 1500, lambda v: len(v["on_shell"]) >= 32),
    "neutral_file_with_conditions": (dict(max_area=0.05), 100, 300,
                                     lambda v: v["lines"].count("BOUNDARY CONDITIONS 2.1.2") == 3),
    "crossing_walls": (dict(max_area=0.1), 160, 500, lambda v: [v["mesh"].points[k] for k in v["common"]] == [[2, 2]]),
}


@pytest.mark.parametrize("script", sorted(CASES))
def test_a_script_makes_a_right_mesh_of_the_expected_size(script, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    bounds, least, most, holds = CASES[script]
    ran = runpy.run_path(str(SCRIPTS / f"{script}.py"))
    mesh = ran["mesh"]
    found = certificate(ran["info"], mesh, **bounds)
    assert found.valid, str(found)
    assert least <= len(mesh.elements) <= most
    assert holds(ran)


def test_each_script_has_a_case_and_imports_no_other_package():
    assert sorted(path.stem for path in SCRIPTS.glob("*.py")) == sorted(CASES)
    for path in SCRIPTS.glob("*.py"):
        imports = [line for line in path.read_text().splitlines() if line.startswith(("import ", "from "))]
        assert all(line.split()[1].split(".")[0] in ("pardel", "numpy", "pickle", "copy") for line in imports)
        assert 10 <= len(path.read_text().splitlines()) <= 40


def test_functions_have_the_parameters_of_meshpy():
    def defaults(function):
        return {name: p.default for name, p in inspect.signature(function).parameters.items()}

    none = inspect.Parameter.empty
    assert defaults(triangle.build) == dict(
        mesh_info=none, verbose=False, refinement_func=None, attributes=False, volume_constraints=False,
        max_volume=None, allow_boundary_steiner=True, allow_volume_steiner=True, quality_meshing=True,
        generate_edges=None, generate_faces=False, min_angle=None, mesh_order=None, generate_neighbor_lists=False)
    assert defaults(triangle.refine) == dict(input_p=none, verbose=False, refinement_func=None, quality_meshing=True,
                                             min_angle=None, generate_neighbor_lists=False)
    assert list(defaults(triangle.subdivide_facets)) == ["subdivisions", "points", "facets", "facet_markers"]
    assert list(defaults(triangle.write_gnuplot_mesh)) == ["filename", "out_p", "facets"]


def test_both_ways_of_importing_give_one_module():
    import pardel.compat.meshpy.triangle as imported
    assert imported is triangle


@pytest.mark.parametrize("module", [
    "pardel.compat.meshpy", *(f"pardel.compat.meshpy.{name}" for name in ("building", "facets", "foreign_array",
                                                                          "geometry"))])
def test_the_examples_are_true(module):
    failed, tried = doctest.testmod(importlib.import_module(module))
    assert tried > 0 and failed == 0


def test_the_examples_of_the_page_are_true(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    failed, tried = doctest.testfile(os.environ["PARDEL_SOURCE"] + "/docs/python_meshpy.md", module_relative=False)
    assert tried > 5 and failed == 0


# MeshInfo and its arrays.

def test_an_array_of_markers_has_numbers_after_setup_only():
    info = square()
    assert not info.point_markers.allocated and len(info.point_markers) == 4
    with pytest.raises(RuntimeError, match="point_markers is not allocated"):
        info.point_markers[0]
    info.point_markers.setup()
    info.point_markers[2] = 7
    assert list(info.point_markers) == [0, 0, 7, 0] and info.point_markers.allocated
    info.point_markers.deallocate()
    assert not info.point_markers.allocated


def test_resizing_points_resizes_their_markers():
    info = square()
    info.point_markers.setup()
    info.point_markers[3] = 5
    info.points.resize(6)
    assert list(info.point_markers) == [0, 0, 0, 5, 0, 0] and info.points[5] == [0, 0]
    with pytest.raises(RuntimeError, match="point_markers has the length of points"):
        info.point_markers.resize(3)


def test_rows_are_read_and_set_by_one_number_and_by_two():
    points = square().points
    points[1, 1] = 17
    assert points[1] == [1.0, 17.0] and points[1, 1] == 17 and points[-1] == [0, 1] and points.unit == 2
    for index in (4, -5, (4, 0), (0, 2), (0, 1, 2)):
        with pytest.raises(IndexError):
            points[index]
    with pytest.raises(ValueError, match=r"points\[0\]: the value must be a sequence of length 2"):
        points[0] = (1, 2, 3)


@pytest.mark.parametrize("facets", [[(0, 1, 2)], [(0, 1), (1, 2, 3)]])
def test_a_facet_needs_two_points(facets):
    with pytest.raises(ValueError, match="the value must be a sequence of length 2"):
        triangle.MeshInfo().set_facets(facets)


def test_a_facet_of_fractions_is_refused():
    with pytest.raises(ValueError, match="facets: 32-bit integers are needed"):
        triangle.MeshInfo().set_facets([(0, 0.5)])


def test_a_wrong_number_of_markers_is_refused():
    with pytest.raises(ValueError, match="facet_markers: 3 values are given; 4 are needed"):
        square(facet_markers=[1, 2, 3])


def test_a_facet_of_a_missing_point_is_named():
    info = square()
    info.facets[2] = (2, 9)
    with pytest.raises(pardel.UsageError, match=r"segments\[2\] has the point 9"):
        triangle.build(info)


def test_points_may_have_attributes():
    info = square()
    info.number_of_point_attributes = 2
    info.point_attributes.setup()
    for k in range(4):
        info.point_attributes[k] = (k, 10 * k)
    mesh = triangle.build(info, max_volume=0.01)
    values = np.array(mesh.point_attributes)
    assert mesh.number_of_point_attributes == 2 and np.allclose(values[:, 1], 10 * values[:, 0])


def test_a_copy_has_arrays_of_its_own():
    info = square(facet_markers=[1, 2, 3, 4])
    other = info.copy()
    other.points[0] = (9, 9)
    other.facet_markers[0] = 9
    assert info.points[0] == [0, 0] and info.facet_markers[0] == 1 and not other.point_markers.allocated


def test_a_pickle_has_all_arrays():
    mesh = triangle.build(square(facet_markers=[1, 2, 3, 4]), max_volume=0.05, mesh_order=2, generate_faces=True)
    again = pickle.loads(pickle.dumps(mesh))
    for name in ("points", "point_markers", "elements", "neighbors", "facets", "facet_markers", "faces",
                 "face_markers"):
        assert np.array_equal(np.array(getattr(again, name)), np.array(getattr(mesh, name)))
    assert again.number_of_element_vertices == 6 and not again.element_volumes.allocated


def test_dump_names_every_array(capsys):
    square().dump()
    assert "array points: 4 elements, 2 values per element\n  0: 0.0,0.0" in capsys.readouterr().out


# build

def test_neighbors_are_across_the_side_opposite_each_corner():
    mesh = triangle.build(square(), max_volume=0.05)
    elements, neighbors = np.array(mesh.elements), np.array(mesh.neighbors)
    for t, k in np.argwhere(neighbors >= 0):
        shared = set(elements[t]) & set(elements[neighbors[t, k]])
        assert shared == set(elements[t]) - {elements[t, k]}


def test_faces_are_all_edges_once_with_the_markers_of_facets():
    mesh = triangle.build(square(facet_markers=[5, 6, 7, 8]), max_volume=0.05, generate_faces=True)
    assert len(mesh.points) - len(mesh.faces) + len(mesh.elements) == 1  # Euler
    assert set(mesh.face_markers) == {0, 5, 6, 7, 8}
    assert not triangle.build(square()).faces.allocated


def test_an_exception_of_a_refinement_function_comes_back_as_itself():
    def fail(vertices, area):
        raise Own(f"at {vertices[0].x}")

    with pytest.raises(Own, match="at 0"):
        triangle.build(square(), refinement_func=fail)
    with pytest.raises(Own):
        triangle.refine(triangle.build(square()), refinement_func=fail)


def test_a_refinement_function_gets_three_vertices_and_their_area():
    seen = []

    def look(vertices, area):
        (ax, ay), b, c = vertices
        seen.append(abs(area - ((b[0] - ax) * (c.y - ay) - (c.x - ax) * (b[1] - ay)) / 2) < 1e-15 and len(c) == 2)
        return area > 0.1

    triangle.build(square(), refinement_func=look)
    assert len(seen) > 20 and all(seen)


def test_a_refinement_function_that_returns_nothing_is_an_error():
    with pytest.raises(TypeError, match="refinement_func returned None"):
        triangle.build(square(), refinement_func=lambda vertices, area: None)


def test_areas_of_regions_are_bounds_only_if_they_are_asked_for():
    info = square()
    info.regions.resize(1)
    info.regions[0] = (0.5, 0.5, 3, 0.01)
    without, attributes = triangle.build(info), triangle.build(info, attributes=True)
    assert len(without.elements) == len(attributes.elements) < 20
    assert set(attributes.element_attributes) == {3} and not without.element_attributes.allocated
    fine = triangle.build(info, volume_constraints=True)
    assert certificate(info, fine, max_area=0.01)
    both = triangle.build(info, volume_constraints=True, max_volume=0.001)
    assert certificate(info, both, max_area=0.001)


def test_quality_meshing_can_be_left_out():
    mesh = triangle.build(square(), quality_meshing=False)
    assert len(mesh.elements) == 2
    large = triangle.build(square(), quality_meshing=False, max_volume=0.1)
    assert certificate(square(), large, min_angle=0, max_area=0.1)


def test_facets_stay_whole_where_they_must():
    points, facets = triangle.subdivide_facets(
        [6, 6, 6, 6, 1], [(0, 0), (1, 0), (1, 1), (0, 1), (0.5, 0.2), (0.5, 0.8)],
        [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5)])
    info = triangle.MeshInfo()
    info.set_points(points)
    info.set_facets(facets)
    outside = triangle.build(info, max_volume=0.01, allow_boundary_steiner=False)
    assert len(outside.facets) > 25 and sum(marker == 1 for marker in outside.facet_markers) == 24
    whole = triangle.build(info, max_volume=0.01, allow_boundary_steiner=False, allow_volume_steiner=False)
    assert len(whole.facets) == 25 and len(whole.elements) > 50
    with pytest.raises(ValueError, match="allow_volume_steiner is False"):
        triangle.build(info, allow_volume_steiner=False)


def test_points_in_a_hole_are_left_out():
    info = square()
    info.points.resize(9)
    for k, place in enumerate([(0.3, 0.3), (0.7, 0.3), (0.7, 0.7), (0.3, 0.7), (0.5, 0.5)]):
        info.points[4 + k] = place
    info.set_facets([(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4)])
    info.set_holes([(0.5, 0.4)])
    mesh = triangle.build(info, quality_meshing=False)
    assert len(mesh.points) == 8 and set(np.array(mesh.elements).ravel()) == set(range(8))


def test_without_facets_the_convex_hull_is_meshed():
    info = triangle.MeshInfo()
    info.set_points(np.random.default_rng(3).random((30, 2)))
    mesh = triangle.build(info)
    assert pardel.check(np.array(info.points), (np.array(mesh.points), np.array(mesh.elements)), min_angle=20)


def test_generate_edges_is_an_old_name_of_generate_faces():
    with pytest.warns(UserWarning, match="generate_edges is an old name"):
        assert triangle.build(square(), generate_edges=True).faces.allocated


@pytest.mark.parametrize("arguments, message", [
    (dict(mesh_order=3), "mesh_order is 3"), (dict(min_angle="steep"), "min_angle is 'steep'"),
    (dict(max_volume=-1), "largest area must be positive"), (dict(refinement_func=3), "refinement_func is 3")])
def test_a_wrong_argument_is_named(arguments, message):
    with pytest.raises(pardel.UsageError, match=message):
        triangle.build(square(), **arguments)


def test_something_that_is_no_mesh_info_is_refused():
    for function, name in ((triangle.build, "mesh_info"), (triangle.refine, "input_p")):
        for value in ([(0, 0), (1, 0), (0, 1)], np.eye(2), None):
            with pytest.raises(TypeError, match=f"^{name} is a {type(value).__name__}; a MeshInfo is needed"):
                function(value)


def test_an_open_outline_is_an_error():
    info = square()
    info.facets.resize(3)
    with pytest.raises(pardel.InvalidInput):
        triangle.build(info)


# refine

def test_a_refined_mesh_keeps_points_facets_and_attributes():
    info = square(facet_markers=[1, 2, 3, 4])
    info.points.resize(6)
    info.points[4], info.points[5] = (0.5, 0), (0.5, 1)
    info.set_facets([(0, 4), (4, 1), (1, 2), (2, 5), (5, 3), (3, 0), (4, 5)], [1, 1, 2, 3, 3, 4, 50])
    info.regions.resize(2)
    info.regions[0], info.regions[1] = (0.2, 0.5, 10, 0), (0.7, 0.5, 20, 0)
    coarse = triangle.build(info, attributes=True, max_volume=0.05)
    mesh = triangle.refine(coarse, refinement_func=lambda vertices, area: area > 0.002)
    assert list(mesh.points)[:len(coarse.points)] == list(coarse.points)
    wall = [facet for facet, marker in zip(mesh.facets, mesh.facet_markers) if marker == 50]
    assert len(wall) > 5 and all(mesh.points[end][0] == 0.5 for facet in wall for end in facet)
    for corners, attribute in zip(mesh.elements, mesh.element_attributes):
        assert attribute == (10 if np.mean([mesh.points[c][0] for c in corners]) < 0.5 else 20)
    assert certificate(info, mesh, max_area=0.002)


def test_refining_without_bounds_changes_nothing():
    coarse = triangle.build(square(), max_volume=0.01)
    assert list(triangle.refine(coarse).points) == list(coarse.points)


def test_refining_something_without_elements_is_an_error():
    with pytest.raises(pardel.UsageError, match="no elements to refine"):
        triangle.refine(square())


# Helpers

def test_subdivided_facets_are_divided_in_equal_parts():
    points, facets = triangle.subdivide_facets([1, 4], [(0, 0), (1, 0), (1, 2)], [(0, 1), (1, 2)])
    assert points[3:] == [[1, 0.5], [1, 1], [1, 1.5]] and facets == [(0, 1), (1, 3), (3, 4), (4, 5), (5, 2)]
    for wrong in ([1], [1, 0]):
        with pytest.raises(pardel.UsageError, match="subdivisions"):
            triangle.subdivide_facets(wrong, [(0, 0), (1, 0), (1, 2)], [(0, 1), (1, 2)])


def test_a_gnuplot_file_has_closed_outlines(tmp_path):
    mesh = triangle.build(square(), quality_meshing=False)
    triangle.write_gnuplot_mesh(tmp_path / "mesh.dat", mesh)
    blocks = (tmp_path / "mesh.dat").read_text().strip().split("\n\n")
    assert [len(block.splitlines()) for block in blocks] == [4, 4]
    assert all(block.splitlines()[0] == block.splitlines()[-1] for block in blocks)


def test_a_neutral_file_has_each_side_with_a_marker_once(tmp_path):
    mesh = triangle.build(square(facet_markers=[1, 2, 3, 4]), max_volume=0.05, generate_faces=True)
    with open(tmp_path / "a.neu", "w") as file:
        mesh.write_neu(file, {frozenset([1, 2]): ("wall", 8)}, periodicity=(3, (0, 1)))
    text = (tmp_path / "a.neu").read_text()
    wall, periodic = [part.splitlines() for part in text.split("BOUNDARY CONDITIONS 2.1.2\n")[1:]]
    assert len(wall) - 2 == sum(marker in (1, 2) for marker in mesh.facet_markers)
    assert periodic[0].startswith("periodic 0 1") and wall[0].split() == ["wall", "1", str(len(wall) - 2), "0", "8"]
    elements, points = np.array(mesh.elements), np.array(mesh.points)
    for row in wall[1:-1]:
        element, kind, side = map(int, row.split())
        ends = points[elements[element - 1][[side - 1, side % 3]]]
        assert kind == 3 and (np.all(ends[:, 1] == 0) or np.all(ends[:, 0] == 1))


def test_a_neutral_file_without_faces_has_no_conditions(tmp_path):
    with open(tmp_path / "a.neu", "w") as file, pytest.warns(UserWarning, match="the mesh has no faces"):
        triangle.build(square()).write_neu(file, {1: ("wall", 8)})
    assert "BOUNDARY" not in (tmp_path / "a.neu").read_text()


def test_geometry_is_put_together_with_markers_and_moved():
    from pardel.compat.meshpy.geometry import GeometryBuilder, Marker, bounding_box, make_box
    builder = GeometryBuilder()
    builder.add_geometry([(0, 0), (1, 0), (0, 1)], [(0, 1), (1, 2), (2, 0)])
    builder.add_geometry(*make_box((3, 0), (4, 1)))
    assert builder.facet_markers == [0, 0, 0, Marker.MINUS_Y, Marker.PLUS_X, Marker.PLUS_Y, Marker.MINUS_X]
    assert builder.facets[3:] == [(3, 4), (4, 5), (5, 6), (6, 3)] and builder.mesher_module() is triangle
    builder.apply_transform(lambda p: (p[0] + 1, 2 * p[1]))
    low, high = bounding_box(builder.points)
    assert low.tolist() == [1, 0] and high.tolist() == [5, 2] and builder.center().tolist() == [3, 1]
    with pytest.raises(pardel.UsageError, match="pardel meshes two dimensions"):
        make_box((0, 0, 0), (1, 1, 1))
