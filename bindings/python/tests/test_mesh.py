"""pardel.mesh: the bounds hold, and the arrays are what they say."""

import numpy as np
import pytest

import pardel


def angles(mesh):
    corners = mesh.points[mesh.triangles]
    sides = [np.linalg.norm(corners[:, (k + 1) % 3] - corners[:, (k + 2) % 3], axis=1) for k in range(3)]
    cosines = [(sides[(k + 1) % 3]**2 + sides[(k + 2) % 3]**2 - sides[k]**2) /
               (2 * sides[(k + 1) % 3] * sides[(k + 2) % 3]) for k in range(3)]
    return np.degrees(np.arccos(np.clip(cosines, -1, 1)))


def areas(mesh):
    a, b, c = np.moveaxis(mesh.points[mesh.triangles], 1, 0)
    return 0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])


def longest_edges(mesh):
    ends = mesh.points[mesh.edges]
    return np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1)


def test_points_and_segments_become_a_mesh():
    made = pardel.mesh([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1), (1, 2), (2, 3), (3, 0)])
    assert len(made.triangles) >= 2 and made.report.goal_met


def test_points_alone_stand_for_their_convex_hull(random_points):
    made = pardel.mesh(random_points)
    assert pardel.check(random_points, made)


def test_a_domain_may_be_the_path_of_a_file(tmp_path, square):
    pardel.write(tmp_path / "square.poly", square)
    assert pardel.mesh(tmp_path / "square.poly", max_area=0.1).digest == pardel.mesh(square, max_area=0.1).digest


def test_no_angle_is_below_the_bound(plate):
    assert angles(pardel.mesh(plate, min_angle=33)).min() >= 33 - 1e-9


def test_no_area_is_above_the_bound(square):
    assert areas(pardel.mesh(square, max_area=0.003)).max() <= 0.003 * (1 + 1e-12)


def test_no_edge_is_longer_than_the_bound(square):
    assert longest_edges(pardel.mesh(square, max_edge=0.07)).max() <= 0.07 * (1 + 1e-12)


def test_a_hole_has_no_triangles(plate):
    made = pardel.mesh(plate)
    centroids = made.points[made.triangles].mean(axis=1)
    assert not np.any(np.all((centroids > 1) & (centroids < 3), axis=1))
    assert made.area() == pytest.approx(12)


def test_the_points_of_the_domain_come_first_and_unchanged(plate):
    made = pardel.mesh(plate, max_area=0.1)
    assert np.array_equal(made.points[:len(plate.points)], plate.points)


def test_triangles_are_counter_clockwise(plate):
    assert areas(pardel.mesh(plate, max_area=0.1)).min() > 0


def test_neighbours_refer_back_to_each_other(plate):
    made = pardel.mesh(plate, max_area=0.1)
    for triangle, row in enumerate(made.neighbors):
        assert all(triangle in made.neighbors[other] for other in row if other >= 0)


def test_the_neighbour_lies_across_the_edge_opposite_the_corner(square):
    made = pardel.mesh(square, max_area=0.1)
    for triangle, row in enumerate(made.neighbors):
        for corner, other in enumerate(row):
            edge = set(made.triangles[triangle]) - {made.triangles[triangle][corner]}
            assert other < 0 or edge <= set(made.triangles[other])


def test_each_edge_is_listed_once(plate):
    made = pardel.mesh(plate, max_area=0.1)
    sides = np.sort(np.concatenate([made.triangles[:, [0, 1]], made.triangles[:, [1, 2]], made.triangles[:, [2, 0]]]))
    assert np.array_equal(np.unique(sides, axis=0), np.unique(np.sort(made.edges), axis=0))
    assert len(made.edges) == len(np.unique(sides, axis=0))


def test_edges_have_the_markers_of_their_segments(square):
    made = pardel.mesh(square, max_edge=0.3)
    on_right = np.all(made.points[made.edges][:, :, 0] == 1, axis=1)
    assert set(made.edge_markers[on_right]) == {2}
    assert set(made.edge_markers) == {0, 1, 2, 3, 4}


def test_edges_without_markers_are_1_on_the_boundary_and_0_inside(plate):
    made = pardel.mesh(plate, max_area=0.1)
    assert np.count_nonzero(made.edge_markers) == np.count_nonzero(made.neighbors == -1)


def test_segments_know_the_segment_of_the_domain(square):
    made = pardel.mesh(square, max_edge=0.3)
    assert np.array_equal(made.segment_markers, made.segment_ids + 1)


def test_points_have_the_markers_of_their_segments(square):
    made = pardel.mesh(square, max_edge=0.3)
    inside = np.all((made.points > 0) & (made.points < 1), axis=1)
    assert not made.point_markers[inside].any() and made.point_markers[~inside].all()


def test_given_point_markers_stay(square):
    made = pardel.mesh(square.points, square.segments, point_markers=[5, 6, 7, 8])
    assert made.point_markers[:4].tolist() == [5, 6, 7, 8]


def test_attributes_are_interpolated_at_new_points(square):
    made = pardel.mesh(square.points, square.segments, attributes=square.points @ [[2.0], [3.0]], max_area=0.01)
    assert made.attributes.shape == (len(made.points), 1)
    assert made.attributes[:, 0] == pytest.approx(made.points @ [2.0, 3.0])


def test_regions_give_attributes_and_largest_areas():
    points = [(0, 0), (1, 0), (2, 0), (2, 1), (1, 1), (0, 1)]
    segments = [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0), (1, 4)]
    made = pardel.mesh(points, segments, regions=[(0.5, 0.5, 10, 0.01), (1.5, 0.5, 20, 0)])
    attribute = made.region_attributes[made.regions]
    left = made.points[made.triangles].mean(axis=1)[:, 0] < 1
    assert set(attribute[left]) == {10} and set(attribute[~left]) == {20}
    assert areas(made)[left].max() <= 0.01 < areas(made)[~left].max()


def test_a_mesh_without_regions_has_an_empty_array_of_them(square):
    assert pardel.mesh(square).regions.shape == (0,)


def test_quality_is_measured(plate):
    made = pardel.mesh(plate, min_angle=30, max_area=0.1)
    quality = made.quality()
    assert quality.min_angle == pytest.approx(angles(made).min())
    assert quality.max_angle == pytest.approx(angles(made).max())
    assert (quality.vertices, quality.triangles) == (len(made.points), len(made.triangles))


def test_a_conforming_mesh_is_delaunay(plate):
    assert pardel.check(plate, pardel.mesh(plate, conforming=True), conforming=True)


def test_max_vertices_ends_the_refinement_and_the_report_says_so(square):
    made = pardel.mesh(square, max_area=1e-4, max_vertices=200)
    assert len(made.points) == 200 and not made.report.goal_met
    assert set(made.report.exempt_counts) == {"budget"}


def test_small_angles_of_the_domain_are_exempt_and_named():
    made = pardel.mesh([(0, 0), (10, 0), (10, 1)], [(0, 1), (1, 2), (2, 0)])
    assert made.report.goal_met and made.report.exempt
    assert {each.apex for each in made.report.exempt} == {0}


def test_exempt_triangles_are_a_sequence(square):
    made = pardel.mesh(square, max_area=1e-4, max_vertices=200)
    exempt = made.report.exempt
    assert [each.triangle for each in exempt] == exempt.triangles.tolist()
    assert exempt[-1] == list(exempt)[-1] and exempt[1:3] == tuple(exempt)[1:3]
    assert repr(exempt) == f"Exemptions({{'budget': {len(exempt)}}})"


def test_narrow_places_are_reported_as_gaps():
    made = pardel.mesh(pardel.polygon([(0, 0), (1, 0), (1, 1e-8), (1, 1), (0, 1)]))
    assert made.report.gaps and made.report.gaps[0].distance == pytest.approx(1e-8)


def test_segments_may_be_kept_whole(square):
    assert len(pardel.mesh(square, max_edge=0.2, min_angle=0, split_segments=False).segments) == 4


def test_an_interior_can_be_filled_with_equilateral_triangles(square):
    made = pardel.mesh(square, max_edge=0.02, interior="fill")
    assert made.report.laid > 0 and pardel.check(square, made, max_edge=0.02)


def test_placements_make_different_meshes(square):
    made = {word: pardel.mesh(square, max_area=0.01, min_angle=30, placement=word).digest
            for word in ("off_centre", "circumcentre", "search")}
    assert len(set(made.values())) == 3


def test_the_number_of_threads_changes_no_bit(plate):
    made = [pardel.mesh(plate, max_area=1e-4, threads=threads) for threads in (1, 2, 3, 8)]
    for other in made[1:]:
        for name in ("points", "triangles", "neighbors", "edges", "edge_markers"):
            assert np.array_equal(getattr(made[0], name), getattr(other, name))


def test_the_digest_tells_meshes_apart(square):
    assert pardel.mesh(square, max_area=0.1).digest == pardel.mesh(square, max_area=0.1).digest
    assert pardel.mesh(square, max_area=0.1).digest != pardel.mesh(square, max_area=0.01).digest


def test_an_invalid_domain_is_refused_with_its_problems(crossing):
    with pytest.raises(pardel.InvalidInput) as caught:
        pardel.mesh(crossing)
    (problem,) = caught.value.problems
    assert (problem.kind, problem.ids, problem.coordinates) == ("crossing_segments", (0, 2), (1.0, 1.0))
    assert problem.text in str(caught.value)


def test_an_invalid_domain_can_be_repaired_on_the_way(crossing):
    made = pardel.mesh(crossing, repair=True, max_area=0.1)
    assert made.report.repairs and pardel.check(made.domain, made, max_area=0.1)


def test_a_snapping_distance_means_repair():
    nearly = pardel.Domain([(0, 0), (1, 0), (1, 1), (0, 1), (0, 1e-5)], [(0, 1), (1, 2), (2, 3), (3, 4)])
    made = pardel.mesh(nearly, snap=1e-4)
    assert len(made.domain.points) == 4 and made.area() == pytest.approx(1)


def test_a_mesh_shows_its_size(square):
    assert repr(pardel.mesh(square, min_angle=0)) == "Mesh(4 points, 2 triangles)"


def test_the_delaunay_triangulation_adds_no_point(random_points):
    made = pardel.delaunay(random_points)
    assert np.array_equal(made.points, random_points)
    assert pardel.check(random_points, made, min_angle=0, conforming=True)


def test_a_constrained_triangulation_keeps_segments(square):
    points = np.concatenate([square.points, [(0.1, 0.5), (0.9, 0.5), (0.5, 0.501), (0.5, 0.499)]])
    made = pardel.delaunay(points, np.concatenate([square.segments, [(4, 5)]]))
    assert {4, 5} in [set(edge) for edge in made.edges.tolist()]


def test_the_convex_hull_goes_counter_clockwise_around_all_points(random_points):
    hull = random_points[pardel.convex_hull(random_points)]
    ahead = np.roll(hull, -1, axis=0) - hull
    for point in random_points:
        towards = point - hull
        assert np.all(ahead[:, 0] * towards[:, 1] - ahead[:, 1] * towards[:, 0] >= -1e-15)


def test_an_exempt_triangle_names_the_small_angle_of_the_domain():
    sharp = pardel.mesh([(4, 0.2), (0, 0), (4, 0)], [(0, 1), (1, 2), (2, 0)], min_angle=30, max_area=0.01)
    assert {each.triangle for each in sharp.report.exempt} - {1}
    for each in sharp.report.exempt:
        assert each.apex == 1 and each.angle == pytest.approx(np.degrees(np.arctan2(0.2, 4)))
        assert each.reason in ("nestled", "seditious")
