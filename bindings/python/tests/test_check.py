"""pardel.check: meshes of any program, right and wrong ones."""

from types import SimpleNamespace

import numpy as np
import pytest

import pardel


def test_a_mesh_of_pardel_is_certified(plate):
    certificate = pardel.check(plate, pardel.mesh(plate, min_angle=30, max_area=0.1), min_angle=30, max_area=0.1)
    assert certificate.valid and certificate and certificate.violations == () and certificate.not_checked == ()


def test_arrays_are_checked_without_what_they_lack(plate):
    made = pardel.mesh(plate, max_area=0.1)
    assert pardel.check(plate, (made.points, made.triangles), max_area=0.1).valid


def test_objects_with_points_and_cells_are_checked(plate):
    made = pardel.mesh(plate, max_area=0.1)
    in_space = np.column_stack([made.points, np.zeros(len(made.points))])
    cells = [SimpleNamespace(type="line", data=made.segments), SimpleNamespace(type="triangle", data=made.triangles)]
    assert pardel.check(plate, SimpleNamespace(points=in_space, cells=cells))
    assert pardel.check(plate, SimpleNamespace(points=made.points, cells={"triangle": made.triangles}))
    assert pardel.check(plate, SimpleNamespace(points=made.points, cells=[("triangle", made.triangles)]))


def test_cells_that_are_no_triangles_are_refused(plate):
    with pytest.raises(pardel.UsageError, match="cells of the type quad; triangles are needed"):
        pardel.check(plate, SimpleNamespace(points=plate.points, cells={"quad": [(0, 1, 2, 3)]}))


@pytest.mark.parametrize("suffix", ["vtu", "msh", "node", "off", "vtk"])
def test_files_are_checked(plate, tmp_path, suffix):
    pardel.write(tmp_path / "plate.poly", plate)
    made = pardel.mesh(plate, max_area=0.1)
    file = tmp_path / f"mesh.{suffix}"
    pardel.write(file, made)
    assert pardel.check(tmp_path / "plate.poly", file, max_area=0.1)


def test_a_small_angle_is_found_with_its_triangle_and_place(square):
    points = [*square.points.tolist(), (0.5, 0.01)]
    certificate = pardel.check(points, (points, [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]), min_angle=20)
    (violation,) = [each for each in certificate.violations if each.kind == "small_angle"]
    assert not certificate and violation.ids[0] == 0 and len(violation.coordinates[0]) == 2
    assert "small_angle" in violation.text and str(violation) == violation.text


def test_an_edge_that_is_not_delaunay_is_found():
    points = [(0, 0), (2, -0.1), (4, 0), (2, 0.1)]
    assert pardel.check(points, (points, [(0, 1, 3), (1, 2, 3)]), min_angle=0)
    certificate = pardel.check(points, (points, [(0, 1, 2), (0, 2, 3)]), min_angle=0)
    assert certificate.violation_counts == {"not_delaunay": 1}


def test_a_triangle_in_a_hole_is_found(plate):
    filled = pardel.delaunay(plate.points)
    assert "covered_exterior" in pardel.check(plate, (filled.points, filled.triangles), min_angle=0).violation_counts


def test_a_missing_triangle_is_found(square):
    made = pardel.mesh(square, max_area=0.1)
    certificate = pardel.check(square, (made.points, made.triangles[1:]), min_angle=0)
    assert "uncovered_domain" in certificate.violation_counts


def test_a_point_that_moved_is_found(square):
    made = pardel.mesh(square, max_area=0.1)
    points = made.points.copy()
    points[2, 0] = np.nextafter(1, 0)
    assert "missing_input_vertex" in pardel.check(square, (points, made.triangles), min_angle=0).violation_counts


@pytest.mark.parametrize("corner", [99, -1, 2**31, 2**40])
def test_a_corner_out_of_range_is_found(square, corner):
    triangles = np.array([(0, 1, 2), (0, 2, corner)], dtype=np.int64)
    assert "index_out_of_range" in pardel.check(square, (square.points, triangles)).violation_counts


def test_a_coordinate_that_is_not_a_number_is_found(square):
    points = square.points.copy()
    points[3] = np.nan
    assert "non_finite_coordinate" in pardel.check(square, (points, [(0, 1, 2), (0, 2, 3)])).violation_counts


def test_a_mesh_without_triangles_is_no_mesh(square):
    assert not pardel.check(square, (square.points, []))


def test_the_corners_of_triangles_with_six_nodes_are_checked(square):
    class Block:
        type, data = "triangle6", [(0, 1, 2, 4, 5, 6), (0, 2, 3, 6, 7, 8)]

    class Foreign:
        points = [*square.points, (0.5, 0), (1, 0.5), (0.5, 0.5), (0.5, 1), (0, 0.5)]
        cells = [Block]

    found = pardel.check(square, Foreign)
    assert found.triangles == 2 and "area_mismatch" not in found.violation_counts


@pytest.mark.parametrize("bound", [dict(max_area=1e-3), dict(max_edge=0.05), dict(max_circumradius=0.01),
                                   dict(size=lambda x, y: 0.05), dict(min_angle=30.0), dict(grading=0.01),
                                   dict(size=[0.01, 1, 1, 1, 1]), dict(feature_size=20)],
                         ids=lambda bound: "_".join(bound))
def test_each_bound_is_checked(square, bound):
    low = pardel.Domain([*square.points, (0.5, 0.05)], square.segments)
    coarse = pardel.mesh(low, max_area=0.1, min_angle=5)
    assert pardel.check(low, coarse, min_angle=0)
    assert not pardel.check(low, coarse, **{"min_angle": 0, **bound})


def test_areas_of_regions_are_checked(square):
    capped = pardel.Domain(square.points, square.segments, regions=[(0.5, 0.5, 1, 0.001)])
    coarse = pardel.mesh(square, max_area=0.1)
    assert pardel.check(capped, pardel.mesh(capped))
    assert "region_area" in pardel.check(capped, (coarse.points, coarse.triangles)).violation_counts


def test_extremes_have_their_triangles_and_places(plate):
    made = pardel.mesh(plate, max_area=0.1)
    extremes = pardel.check(plate, made).extremes
    assert set(extremes) == {"min_angle", "max_angle", "max_area", "max_edge", "min_edge", "max_circumradius",
                             "max_radius_edge_ratio"}
    assert extremes["min_angle"].value == pytest.approx(made.quality().min_angle)
    corners = made.points[made.triangles[extremes["min_angle"].triangle]]
    assert list(extremes["min_angle"].coordinates) in corners.tolist()


def test_the_certificate_counts(plate):
    made = pardel.mesh(plate, max_area=0.1)
    certificate = pardel.check(plate, made)
    assert (certificate.vertices, certificate.triangles) == (len(made.points), len(made.triangles))
    assert certificate.constrained_edges == len(made.segments)
    assert certificate.area == 12 and certificate.digest == made.digest
    assert sum(certificate.angle_histogram) == 3 * len(made.triangles) and len(certificate.angle_histogram) == 18
    assert "valid" in str(certificate)


def test_the_number_of_listed_violations_is_limited(square):
    made = pardel.mesh(square, max_area=1e-3)
    certificate = pardel.check(square, made, max_area=1e-5, max_violations=5)
    assert len(certificate.violations) == 5 and certificate.violation_counts["large_area"] == len(made.triangles)


def test_an_invalid_domain_is_refused(crossing, square):
    with pytest.raises(pardel.InvalidInput) as caught:
        pardel.check(crossing, pardel.mesh(square))
    assert caught.value.problems[0].kind == "crossing_segments"


def test_a_mesh_of_another_domain_is_wrong(square, plate):
    assert not pardel.check(square, pardel.mesh(plate))


def test_a_refined_mesh_is_right_for_the_domain(plate):
    refined = pardel.refine(pardel.mesh(plate), max_area=0.01, min_angle=30)
    assert pardel.check(plate, refined, max_area=0.01, min_angle=30)


def test_refinement_keeps_the_points_of_a_mesh(plate):
    coarse = pardel.mesh(plate)
    refined = pardel.refine(coarse, max_area=0.01)
    assert np.array_equal(refined.points[:len(coarse.points)], coarse.points)


def test_refinement_takes_one_area_per_triangle(square):
    coarse = pardel.delaunay(square)
    refined = pardel.refine(coarse, max_areas=[0.001, np.inf])
    assert len(refined.triangles) > 300


def test_refinement_takes_one_length_per_point(square):
    refined = pardel.refine(pardel.delaunay(square), size=[0.02, 0.2, 0.2, 0.02])
    assert pardel.check(square, refined, size=[0.02, 0.2, 0.2, 0.02])


def test_a_clockwise_triangle_cannot_be_refined():
    with pytest.raises(pardel.InvalidInput):
        pardel.refine(([(0, 0), (1, 0), (0, 1)], [(0, 2, 1)]))


def test_the_wrong_number_of_areas_is_named(square):
    with pytest.raises(pardel.UsageError, match=r"max_areas has the shape \(5,\); \(2,\) is needed"):
        pardel.refine(pardel.delaunay(square), max_areas=[1] * 5)


@pytest.mark.parametrize("use", [lambda mesh: mesh.edges, lambda mesh: mesh.quality(), lambda mesh: mesh.digest,
                                 lambda mesh: mesh.point_markers, pardel.refine,
                                 lambda mesh: pardel.write("/nowhere.vtu", mesh)])
def test_a_mesh_with_a_corner_out_of_range_is_only_checked(use):
    with pytest.raises(pardel.InvalidInput, match="an index that is not the index of a point"):
        use(pardel.Mesh([(0, 0), (1, 0), (0, 1)], [(0, 1, 7)]))


def test_triangles_of_a_wrong_shape_are_named():
    with pytest.raises(pardel.UsageError, match=r"triangles has the shape \(1, 4\); \(m, 3\) is needed"):
        pardel.Mesh([(0, 0)], [(0, 1, 2, 3)])
    with pytest.raises(pardel.UsageError, match="triangles has the dtype float64; integers are needed"):
        pardel.Mesh([(0, 0)], [(0.0, 1, 2)])


def test_what_is_no_mesh_is_named(square):
    with pytest.raises(pardel.UsageError, match="a mesh is needed.*this is a int"):
        pardel.check(square, 7)
