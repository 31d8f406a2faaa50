// The checker accepts valid meshes and reports the right kind of violation for invalid ones.
#include "../../../properties/checker/check.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "../../../properties/domains/domains.hpp"
#include "cgal_meshes.hpp"
#include "verdicts.hpp"

namespace pardel::checker {
namespace {

using Kind = ViolationKind;
using testing::Case;
using testing::count;
using testing::is_valid;
using testing::no_angle_bound;
using testing::reports;
using testing::reports_only;

TEST(Check, accepts_valid_meshes_made_by_hand) {
  EXPECT_TRUE(is_valid(check(testing::square_in_two())));
  EXPECT_TRUE(is_valid(check(testing::square_in_eight())));
}

TEST(Check, accepts_every_domain_triangulated_by_CGAL) {
  for (const std::string& name : domains::names()) {
    Case c;
    c.pslg = domains::generate(name, 0, 1).value();
    c.mesh = testing::triangulated_by_cgal(c.pslg);
    Goal goal = no_angle_bound();
    goal.region_caps = false;
    EXPECT_TRUE(is_valid(check(c, goal))) << name;
  }
}

TEST(Check, accepts_meshes_far_from_the_origin) {
  Case c;
  c.pslg = domains::moved(domains::key(), 654321, 4987654, 0.01);
  c.mesh = testing::triangulated_by_cgal(c.pslg);
  EXPECT_TRUE(is_valid(check(c)));
}

TEST(Check, accepts_an_empty_mesh_of_an_empty_input) { EXPECT_TRUE(is_valid(check(Case{}))); }

TEST(Check, gives_the_same_certificate_again) {
  Case c;
  c.pslg = domains::random_points(20'000, 3);
  c.mesh = testing::triangulated_by_cgal(c.pslg);
  Goal goal;
  goal.max_area = 1e-5;
  CheckOptions options;
  options.max_violations = 7;
  const std::string first = to_json(check(c, goal, options));
  EXPECT_EQ(first, to_json(check(c, goal, options)));
}

TEST(Check, gives_the_same_certificate_on_any_number_of_threads) {
  Case c;
  c.pslg = domains::random_points(20'000, 5);
  c.mesh = testing::triangulated_by_cgal(c.pslg);
  Goal goal;
  goal.max_area = 1e-4;
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const std::string alone = to_json(check(c, goal));
  for (const int several : {2, 3, 8}) {
    omp_set_num_threads(several);
    EXPECT_EQ(to_json(check(c, goal)), alone) << several;
  }
  omp_set_num_threads(threads);
}

// Tests of ids, counts and numbers.

TEST(Check, survives_and_reports_ids_out_of_range) {
  for (const Index id : {Index{4}, Index{1'000'000'000}, no_index}) {
    Case c = testing::square_in_two();
    c.mesh.triangles[1].v[2] = id;
    EXPECT_TRUE(reports(check(c), Kind::index_out_of_range)) << id;
  }
  Case c = testing::square_in_two();
  c.mesh.triangles[0].n[0] = 77;
  EXPECT_TRUE(reports(check(c), Kind::index_out_of_range));
  c = testing::square_in_two();
  for (const Index id : {Index{4}, Index{99}})
    for (Index ConstrainedEdge::*end : {&ConstrainedEdge::a, &ConstrainedEdge::b}) {
      c = testing::square_in_two();
      c.mesh.constrained_edges[0].*end = id;
      EXPECT_TRUE(reports_only(check(c), Kind::index_out_of_range));
    }
  c = testing::square_in_eight();
  c.mesh.region[3] = 2;
  EXPECT_TRUE(reports_only(check(c), Kind::index_out_of_range));
  c = testing::square_in_two();
  c.pslg.segments[0].b = 4;
  EXPECT_TRUE(reports_only(check(c), Kind::index_out_of_range));
}

TEST(Check, reports_coordinates_that_are_not_finite) {
  for (const double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Case c = testing::square_in_two();
    c.mesh.points[2].y = x;
    EXPECT_TRUE(reports_only(check(c), Kind::non_finite_coordinate));
    c = testing::square_in_two();
    c.pslg.points[2].y = x;
    EXPECT_TRUE(reports_only(check(c), Kind::non_finite_coordinate));
    c = testing::square_in_two();
    c.pslg.holes.push_back({x, 0});
    EXPECT_TRUE(reports_only(check(c), Kind::non_finite_coordinate));
    c = testing::square_in_eight();
    c.pslg.regions[1].seed.y = x;
    EXPECT_TRUE(reports_only(check(c), Kind::non_finite_coordinate));
  }
}

TEST(Check, reports_arrays_of_the_wrong_length) {
  Case c = testing::square_in_eight();
  c.mesh.origin.pop_back();
  EXPECT_TRUE(reports_only(check(c), Kind::wrong_count));
  c = testing::square_in_eight();
  c.mesh.region.clear();
  EXPECT_TRUE(reports_only(check(c), Kind::wrong_count));
  c = testing::square_in_eight();
  c.mesh.point_markers.clear();
  EXPECT_TRUE(reports_only(check(c), Kind::wrong_count));
  c = testing::square_in_eight();
  c.mesh.attributes_per_point = 3;
  EXPECT_TRUE(reports_only(check(c), Kind::wrong_count));
}

TEST(Check, requires_all_arrays_of_a_mesh_of_the_mesher_and_none_of_a_foreign_mesh) {
  const CheckOptions own, foreign{.foreign = true};
  const auto expect = [&](const Case& c, const std::string& what) {
    EXPECT_TRUE(reports_only(check(c, no_angle_bound(), own), Kind::wrong_count)) << what;
    EXPECT_TRUE(is_valid(check(c, no_angle_bound(), foreign))) << what;
  };
  Case whole = testing::square_in_eight();
  whole.pslg.attributes_per_point = whole.mesh.attributes_per_point = 1;
  whole.pslg.point_attributes = {1, 2, 3, 4, 5, 6};
  whole.mesh.point_attributes.append(std::vector<double>{1, 2, 3, 4, 5, 6, 5.5, 2.5, 3.5});
  EXPECT_TRUE(is_valid(check(whole, no_angle_bound(), own)));
  EXPECT_TRUE(is_valid(check(whole, no_angle_bound(), foreign)));
  Case c = whole;
  c.mesh.origin.clear();
  expect(c, "origin");
  c = whole;
  c.mesh.region.clear();
  expect(c, "region");
  c = whole;
  c.mesh.point_markers.clear();
  expect(c, "point markers");
  c = whole;
  c.mesh.point_attributes.clear();
  c.mesh.attributes_per_point = 0;
  expect(c, "attributes");
  c = whole;
  c.mesh.constrained_edges.clear();
  EXPECT_TRUE(reports_only(check(c, no_angle_bound(), own), Kind::missing_constrained_edge));
  EXPECT_TRUE(is_valid(check(c, no_angle_bound(), foreign)));
}

TEST(Check, requires_that_arrays_of_a_foreign_mesh_are_whole_or_empty) {
  const CheckOptions foreign{.foreign = true};
  Case c = testing::square_in_eight();
  c.mesh.origin.pop_back();
  EXPECT_TRUE(reports_only(check(c, no_angle_bound(), foreign), Kind::wrong_count));
  c = testing::square_in_eight();
  c.mesh.region.pop_back();
  EXPECT_TRUE(reports_only(check(c, no_angle_bound(), foreign), Kind::wrong_count));
  c = testing::square_in_eight();
  c.mesh.point_markers.pop_back();
  EXPECT_TRUE(reports_only(check(c, no_angle_bound(), foreign), Kind::wrong_count));
}

// Tests of triangles and neighbours.

TEST(Check, reports_clockwise_and_flat_triangles) {
  Case c = testing::square_in_two();
  std::swap(c.mesh.triangles[0].v[0], c.mesh.triangles[0].v[1]);
  std::swap(c.mesh.triangles[0].n[0], c.mesh.triangles[0].n[1]);
  EXPECT_TRUE(reports(check(c), Kind::degenerate_triangle));
  c = testing::square_in_eight();
  c.mesh.points[6] = {2, 0};
  EXPECT_TRUE(reports(check(c), Kind::degenerate_triangle));
  c = testing::square_in_two();
  c.mesh.triangles[0].v[1] = c.mesh.triangles[0].v[0];
  EXPECT_TRUE(reports(check(c), Kind::degenerate_triangle));
}

TEST(Check, names_a_triangle_with_unusable_corners_and_its_corners_in_order) {
  const auto ids_of = [](const std::array<Index, 3>& corners, Kind kind) {
    Case c = testing::square_in_two();
    c.mesh.triangles[1].v = corners;
    const Certificate certificate = check(c);
    const auto found = std::ranges::find(certificate.violations, kind, &Violation::kind);
    return found == certificate.violations.end() ? std::vector<Index>{} : found->ids;
  };
  EXPECT_EQ(ids_of({0, 99, 3}, Kind::index_out_of_range), (std::vector<Index>{1, 0, 99, 3}));
  EXPECT_EQ(ids_of({3, 0, 0}, Kind::degenerate_triangle), (std::vector<Index>{1, 3, 0, 0}));
  EXPECT_EQ(ids_of({0, 0, 3}, Kind::degenerate_triangle), (std::vector<Index>{1, 0, 0, 3}));
}

TEST(Check, reports_a_duplicate_triangle) {
  for (const bool linked : {true, false}) {
    Case c = testing::square_in_eight();
    Triangle copy = c.mesh.triangles[2];
    if (!linked) copy.n = {no_index, no_index, no_index};
    c.mesh.triangles.push_back(copy);
    c.mesh.region.push_back(1);
    const Certificate certificate = check(c);
    EXPECT_TRUE(reports(certificate, Kind::duplicate_triangle));
    EXPECT_TRUE(reports(certificate, Kind::non_manifold_edge));
    EXPECT_TRUE(reports(certificate, Kind::area_mismatch));
  }
}

TEST(Check, reports_neighbours_that_are_missing_or_wrong) {
  Case c = testing::square_in_eight();
  c.mesh.triangles[3].n = {no_index, no_index, no_index};
  EXPECT_TRUE(reports_only(check(c), Kind::wrong_neighbour));
  c = testing::square_in_eight();
  std::swap(c.mesh.triangles[3].n[0], c.mesh.triangles[3].n[1]);
  EXPECT_TRUE(reports_only(check(c), Kind::wrong_neighbour));
  c = testing::square_in_two();
  c.mesh.triangles[0].n = {no_index, no_index, no_index};
  c.mesh.triangles[1].n = {no_index, no_index, no_index};
  EXPECT_TRUE(reports_only(check(c), Kind::wrong_neighbour)) << "missing on both sides";
}

/// The triangles around a vertex turn by 360 degrees and then once more over the first one.
TEST(Check, reports_an_edge_with_two_triangles_on_one_side_of_which_one_begins_a_fan_and_one_ends_it) {
  Case c;
  c.pslg.points = {{0, 0}, {1, 0}, {0, 1}, {-1, -1}, {0.25, 0.5}};
  for (const Index corner : {1, 2, 3}) c.pslg.segments.push_back({corner, corner % 3 + 1, 0});
  for (const Point p : c.pslg.points) c.mesh.points.push_back(p);
  c.mesh.origin.resize(c.mesh.points.size(), input_vertex);
  const Index last = 3;
  for (const auto& [a, b] : {std::pair<Index, Index>(1, 2), {2, 3}, {3, 1}, {1, 4}}) {
    const auto t = static_cast<Index>(c.mesh.triangles.size());
    c.mesh.triangles.push_back({{0, a, b}, {no_index, t == last ? no_index : t + 1, t == 0 ? no_index : t - 1}});
  }
  EXPECT_TRUE(reports(check(c), Kind::non_manifold_edge));
}

/// Seven triangles that stand on the lower side of a large one. Their numbers do not ascend along this side.
TEST(Check, reports_the_edges_that_meet_an_edge_in_the_order_of_their_vertices) {
  Case c;
  c.pslg.points = {{0, 0}, {80, 0}, {40, 50}};
  c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 0, 0}};
  std::vector<Point> points = c.pslg.points;
  std::vector<std::array<Index, 3>> triangles{{0, 1, 2}};
  for (const double x : {60.0, 10.0, 40.0, 20.0, 70.0, 50.0, 30.0}) {
    const auto v = static_cast<Index>(points.size());
    points.insert(points.end(), {{x, -1}, {x + 2, -1}, {x + 1, 1}});
    triangles.push_back({v, v + 1, v + 2});
  }
  c.mesh = testing::mesh_of(points, triangles);
  std::vector<Index> met;
  for (const Violation& v : check(c).violations)
    if (v.kind == Kind::overlap && v.ids.size() == 4 && v.ids[0] == 0 && v.ids[1] == 1) met.push_back(v.ids[2]);
  EXPECT_EQ(met, (std::vector<Index>{4, 5, 7, 8, 10, 11, 13, 14, 16, 17, 19, 20, 22, 23}));
}

TEST(Check, reports_a_triangle_that_shares_only_a_vertex_and_overlaps) {
  // This triangle overlaps other triangles and shares only the middle vertex of the square with them.
  Case c = testing::square_in_eight();
  c.mesh.points.push_back({3, 2.25});
  c.mesh.points.push_back({3, 2.5});
  c.mesh.origin.resize(11, interior_vertex);
  c.mesh.point_markers.resize(11, 0);
  c.mesh.triangles.push_back({{6, 9, 10}, {no_index, no_index, no_index}});
  c.mesh.region.push_back(1);
  const Certificate certificate = check(c);
  EXPECT_TRUE(reports(certificate, Kind::non_manifold_vertex));
  EXPECT_TRUE(reports(certificate, Kind::overlap));
  EXPECT_TRUE(reports(certificate, Kind::area_mismatch));
}

TEST(Check, reports_a_surface_that_is_not_a_disk_with_holes) {
  // A torus of nine vertices: three by three squares, joined at opposite sides. It cannot lie in the plane, so the
  // checker reports other violations as well.
  Mesh torus;
  for (Index v = 0; v < 9; ++v) torus.points.push_back({double(v % 3), double(v / 3)});
  for (Index j = 0; j < 3; ++j)
    for (Index i = 0; i < 3; ++i) {
      const Index a = 3 * j + i, b = 3 * j + (i + 1) % 3, c = 3 * ((j + 1) % 3) + (i + 1) % 3,
                  d = 3 * ((j + 1) % 3) + i;
      torus.triangles.push_back({{a, b, c}, {}});
      torus.triangles.push_back({{a, c, d}, {}});
    }
  testing::relink(torus);
  Case c;
  c.mesh = torus;
  EXPECT_TRUE(reports(check(c), Kind::euler_characteristic));
}

// Tests of the domain.

TEST(Check, reports_a_triangle_that_is_missing) {
  Case c = testing::square_in_two();
  c.mesh.triangles.pop_back();
  testing::relink(c.mesh);
  const Certificate certificate = check(c);
  EXPECT_TRUE(reports(certificate, Kind::uncovered_domain));
  EXPECT_TRUE(reports(certificate, Kind::broken_segment));
  EXPECT_TRUE(reports(certificate, Kind::missing_input_vertex));
}

TEST(Check, reports_a_face_without_any_triangle) {
  Case c = testing::square_in_two();
  c.mesh.triangles.clear();
  EXPECT_TRUE(reports(check(c), Kind::uncovered_domain));
}

TEST(Check, reports_a_hole_that_is_filled) {
  Case c = testing::square_in_eight();
  c.pslg.holes = {{1, 2}};
  EXPECT_TRUE(reports(check(c), Kind::covered_exterior));
  c.pslg.regions.clear();
  c.mesh.region.clear();
  EXPECT_TRUE(reports(check(c), Kind::covered_exterior));
}

TEST(Check, reports_every_hole_that_is_filled_in_any_order_of_the_holes) {
  const Point left{0.5, 2.75}, right{3.5, 1.25};
  for (const auto& holes : {std::vector{left, right}, std::vector{right, left}}) {
    Case c = testing::square_in_eight();
    c.pslg.holes = holes;
    const std::string text = to_text(check(c));
    for (const char* seed : {"contains the seed of hole 0", "contains the seed of hole 1"})
      EXPECT_NE(text.find(seed), std::string::npos) << seed << " in\n" << text;
  }
}

TEST(Check, reports_a_triangle_outside_the_outline) {
  Case c = testing::square_in_two();
  c.mesh.points.push_back({2, 0.5});
  c.mesh.origin.push_back(interior_vertex);
  c.mesh.triangles.push_back({{1, 4, 2}, {}});
  testing::relink(c.mesh);
  const Certificate certificate = check(c);
  EXPECT_TRUE(reports(certificate, Kind::covered_exterior));
  const auto areas = std::ranges::find(certificate.violations, Kind::area_mismatch, &Violation::kind);
  ASSERT_NE(areas, certificate.violations.end());
  EXPECT_EQ(areas->witness.text(),
            "the triangles' areas sum to 1.5, the area within the boundary is 1; the exact difference rounds to 0.5");
}

TEST(Check, reports_a_triangle_that_lies_on_others) {
  Case c = testing::square_in_two();
  c.mesh.points.append(std::vector<Point>{{0.25, 0.125}, {0.5, 0.125}, {0.5, 0.25}});
  c.mesh.origin.resize(7, interior_vertex);
  c.mesh.triangles.push_back({{4, 5, 6}, {no_index, no_index, no_index}});
  EXPECT_TRUE(reports(check(c), Kind::overlap));
}

TEST(Check, reports_boundary_edges_that_cross) {
  Case c = testing::square_in_two();
  c.mesh.points.append(std::vector<Point>{{0.5, 0.5}, {2, 0.25}, {2, 0.75}});
  c.mesh.origin.resize(7, interior_vertex);
  c.mesh.triangles.push_back({{4, 5, 6}, {no_index, no_index, no_index}});
  EXPECT_TRUE(reports(check(c), Kind::overlap));
}

// Tests of points and segments.

TEST(Check, reports_an_input_point_that_was_moved_or_renumbered) {
  Case c = testing::square_in_two();
  c.mesh.points[2].x = std::nextafter(1.0, 2.0);
  EXPECT_TRUE(reports(check(c), Kind::missing_input_vertex));
  c = testing::square_in_two();
  std::swap(c.mesh.points[1], c.mesh.points[3]);
  EXPECT_TRUE(reports(check(c), Kind::missing_input_vertex));
}

TEST(Check, reports_an_input_point_without_triangles_only_inside_the_domain) {
  Case c = testing::square_in_two();
  c.pslg.points.push_back({5, 5});
  c.mesh.points.push_back({5, 5});
  c.mesh.origin.push_back(input_vertex);
  EXPECT_TRUE(is_valid(check(c))) << "the exterior may have points";
  c.pslg.points[4] = c.mesh.points[4] = {0.5, 0.25};
  EXPECT_TRUE(reports_only(check(c), Kind::missing_input_vertex));
}

TEST(Check, reports_a_vertex_without_triangles) {
  Case c = testing::square_in_two();
  c.mesh.points.push_back({0.5, 0.25});
  c.mesh.origin.push_back(interior_vertex);
  EXPECT_TRUE(reports_only(check(c), Kind::unused_vertex));
}

TEST(Check, reports_a_segment_that_is_not_a_chain_of_edges) {
  Case c = testing::square_in_two();
  c.pslg.segments.push_back({1, 3, 0});
  EXPECT_TRUE(reports(check(c), Kind::broken_segment));
}

TEST(Check, accepts_a_chain_within_the_rounding_distance_and_no_further) {
  const double unit = 0x1p-51;  // the spacing of doubles at 2
  for (const auto& [distance, right] : {std::pair(2 * unit, true), std::pair(3 * unit, false)}) {
    Case c = testing::square_in_eight();
    c.mesh.points[6].x = 2 + distance;
    const Certificate certificate = check(c);
    EXPECT_EQ(count(certificate, Kind::chain_off_segment), right ? 0u : 1u) << to_text(certificate);
    EXPECT_EQ(count(certificate, Kind::broken_segment), 0u);
  }
}

TEST(Check, accepts_that_segments_outside_the_domain_are_absent) {
  Case c = testing::square_in_two();
  c.pslg.points.insert(c.pslg.points.end(), {{3, 3}, {4, 4}});
  c.pslg.segments.push_back({4, 5, 0});
  for (const Point p : {Point{3, 3}, Point{4, 4}}) c.mesh.points.push_back(p);
  c.mesh.origin.resize(6, input_vertex);
  EXPECT_TRUE(is_valid(check(c)));
}

TEST(Check, accepts_that_a_segment_outside_the_domain_is_absent_after_thousands_of_others) {
  Case c;
  c.pslg = domains::comb(1100, 1e-4);
  c.mesh = testing::triangulated_by_cgal(c.pslg);
  const auto end = static_cast<Index>(c.pslg.points.size());
  c.pslg.points.insert(c.pslg.points.end(), {{-8, -8}, {-8, -9}});
  c.pslg.segments.push_back({end, end + 1});
  EXPECT_GT(c.pslg.segments.size(), 4096u) << "more than one block of segments";
  EXPECT_TRUE(is_valid(check(c)));
}

// Tests of labels.

TEST(Check, reports_constrained_edges_that_are_wrong_or_missing) {
  Case c = testing::square_in_two();
  c.mesh.constrained_edges[1].segment = 0;
  EXPECT_TRUE(reports_only(check(c), Kind::wrong_constrained_edge));
  c = testing::square_in_two();
  c.mesh.constrained_edges.push_back({0, 2, 0, 1});
  EXPECT_TRUE(reports_only(check(c), Kind::wrong_constrained_edge)) << "an edge, but no segment";
  c = testing::square_in_two();
  c.mesh.constrained_edges.push_back({1, 3, 0, 1});
  EXPECT_TRUE(reports_only(check(c), Kind::wrong_constrained_edge)) << "no edge";
  c = testing::square_in_two();
  c.mesh.constrained_edges.push_back(c.mesh.constrained_edges[0]);
  EXPECT_TRUE(reports_only(check(c), Kind::wrong_constrained_edge)) << "twice";
  c = testing::square_in_two();
  c.mesh.constrained_edges.pop_back();
  EXPECT_TRUE(reports_only(check(c), Kind::missing_constrained_edge));
}

TEST(Check, reports_markers_that_are_missing_or_wrong) {
  Case c = testing::square_in_eight();
  for (ConstrainedEdge& edge : c.mesh.constrained_edges) edge.marker = 0;
  EXPECT_TRUE(reports_only(check(c), Kind::wrong_edge_marker));
  for (Index v = 0; v < 9; ++v) {
    c = testing::square_in_eight();
    c.mesh.point_markers[v] = 0;
    EXPECT_TRUE(reports_only(check(c), Kind::wrong_vertex_marker)) << v;
  }
  c = testing::square_in_eight();
  c.mesh.point_markers[4] = 5;
  EXPECT_TRUE(is_valid(check(c))) << "a vertex on two segments may have the marker of either";
}

TEST(Check, excuses_a_marker_by_a_segment_outside_the_domain_in_a_foreign_mesh_only) {
  Case c = testing::square_in_two();
  c.pslg.points.push_back({9, 9});
  c.pslg.segments.push_back({2, 4, 6});
  c.mesh.points.push_back({9, 9});
  c.mesh.origin.push_back(input_vertex);
  c.mesh.point_markers.append(std::vector<int>{1, 1, 6, 1, 0});
  EXPECT_TRUE(is_valid(check(c, no_angle_bound(), {.foreign = true})));
  EXPECT_TRUE(reports_only(check(c), Kind::wrong_vertex_marker));
}

TEST(Check, reports_regions_that_are_wrong) {
  Case c = testing::square_in_eight();
  c.mesh.region[2] = 0;
  EXPECT_TRUE(reports_only(check(c), Kind::wrong_region));
  c = testing::square_in_eight();
  c.mesh.region[2] = no_index;
  EXPECT_TRUE(reports_only(check(c), Kind::wrong_region));
  c = testing::square_in_eight();
  c.mesh.region_attributes[1] = 9;
  EXPECT_TRUE(reports_only(check(c), Kind::wrong_region));
}

TEST(Check, reports_origins_that_are_wrong) {
  for (const Index vertex : {0, 6, 7}) {
    Case c = testing::square_in_eight();
    c.mesh.origin[vertex] = interior_vertex;
    EXPECT_TRUE(reports_only(check(c), Kind::wrong_origin)) << vertex;
  }
}

TEST(Check, reports_attributes_that_are_wrong) {
  Case c = testing::square_in_two();
  c.pslg.attributes_per_point = c.mesh.attributes_per_point = 1;
  c.pslg.point_attributes = {1, 2, 3, 4};
  c.mesh.point_attributes.append(c.pslg.point_attributes);
  EXPECT_TRUE(is_valid(check(c)));
  c.mesh.point_attributes[2] = 0;
  EXPECT_TRUE(reports_only(check(c), Kind::wrong_attribute));
}

/// A range has the tolerance of its larger end, whichever this is. An attribute without a range hides no later one.
TEST(Check, judges_each_attribute_by_its_own_range) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Case c = testing::square_in_eight();
  const Index inside = 6;  // in the middle of a segment
  c.pslg.attributes_per_point = c.mesh.attributes_per_point = 2;
  c.pslg.point_attributes.assign(2 * c.pslg.points.size(), 0);
  c.pslg.point_attributes[0] = infinity;
  for (const double end : {-1.0, 1.0}) {
    c.pslg.point_attributes[2 * 4 + 1] = end;  // an end of the segment with the vertex
    c.mesh.point_attributes.resize(2 * c.mesh.points.size(), 0);
    std::ranges::copy(c.pslg.point_attributes, c.mesh.point_attributes.begin());
    const auto with = [&](double value) {
      c.mesh.point_attributes[2 * inside + 1] = value;
      return check(c);
    };
    EXPECT_TRUE(is_valid(with(end)));
    EXPECT_TRUE(is_valid(with(end * (1 + 5e-10))));
    EXPECT_TRUE(is_valid(with(-end * 5e-10)));
    EXPECT_TRUE(reports_only(with(end * (1 + 1e-8)), Kind::wrong_attribute));
    EXPECT_TRUE(reports_only(with(-end * 1e-8), Kind::wrong_attribute));
    EXPECT_TRUE(reports_only(with(777), Kind::wrong_attribute));
  }
}

// Tests of the Delaunay property.

TEST(Check, accepts_either_diagonal_of_cocircular_points_and_only_one_where_they_differ_by_a_unit) {
  Case c = testing::square_in_two();
  EXPECT_TRUE(is_valid(check(c)));
  c.pslg.points[2] = c.mesh.points[2] = {std::nextafter(1.0, 2.0), 1};
  EXPECT_TRUE(reports_only(check(c), Kind::not_delaunay)) << "the diagonal got longer";
}

TEST(Check, requires_delaunay_constrained_edges_only_for_a_conforming_goal) {
  Case c = testing::square_in_two();
  c.pslg.points[2] = c.mesh.points[2] = {2, 2};
  c.pslg.segments.push_back({0, 2, 0});
  c.mesh.constrained_edges.push_back({0, 2, 4, 0});
  EXPECT_TRUE(is_valid(check(c)));
  Goal goal = no_angle_bound();
  goal.conforming = true;
  EXPECT_TRUE(reports_only(check(c, goal), Kind::not_conforming));
}

// Tests of bounds.

TEST(Check, compares_angles_with_the_bound_exactly) {
  const Case c = testing::square_in_two();  // angles of 45 and 90 degrees
  Goal goal;
  goal.min_angle_deg = 44.999999;
  EXPECT_TRUE(is_valid(check(c, goal)));
  goal.min_angle_deg = 45.000001;
  EXPECT_TRUE(reports_only(check(c, goal), Kind::small_angle));
  EXPECT_EQ(count(check(c, goal), Kind::small_angle), 2u);
}

TEST(Check, reports_no_small_angle_of_a_flat_triangle) {
  Case c = testing::square_in_two();
  c.mesh.points.push_back({0.5, 0});
  c.mesh.origin.push_back(origin_on_segment(0));
  c.mesh.triangles.push_back({{0, 4, 1}, {no_index, no_index, no_index}});
  Goal goal;
  goal.min_angle_deg = 20;
  const Certificate certificate = check(c, goal);
  EXPECT_EQ(count(certificate, Kind::degenerate_triangle), 1u);
  EXPECT_EQ(count(certificate, Kind::small_angle), 0u);
}

TEST(Check, names_the_smallest_angle_of_a_triangle_with_two_small_angles) {
  for (const double x : {1.5, 2.5}) {
    Case c;
    c.pslg.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {x, 0.125}};
    c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}};
    c.mesh = testing::triangulated_by_cgal(c.pslg);
    Goal goal;
    goal.min_angle_deg = 20;
    const Certificate certificate = check(c, goal);
    ASSERT_EQ(certificate.violations.size(), 1u) << to_text(certificate);
    EXPECT_EQ(certificate.violations[0].where[0], (Point{x < 2 ? 4.0 : 0.0, 0}));
  }
}

TEST(Check, compares_areas_edges_and_radii_exactly) {
  const Case c = testing::square_in_eight();  // right triangles with legs of 2
  Goal goal = no_angle_bound();
  goal.max_area = 2;
  EXPECT_TRUE(is_valid(check(c, goal)));
  goal.max_area = std::nextafter(2.0, 0.0);
  EXPECT_TRUE(reports_only(check(c, goal), Kind::large_area));
  EXPECT_EQ(count(check(c, goal), Kind::large_area), 8u);

  goal = no_angle_bound();
  goal.max_edge = std::sqrt(8) * (1 + 1e-15);
  EXPECT_TRUE(is_valid(check(c, goal)));
  goal.max_edge = std::sqrt(8) * (1 - 1e-15);
  EXPECT_TRUE(reports_only(check(c, goal), Kind::long_edge));
  EXPECT_EQ(count(check(c, goal), Kind::long_edge), 4u) << "four diagonals, each once";

  CheckOptions options;
  options.max_circumradius = std::sqrt(2) * (1 + 1e-15);
  EXPECT_TRUE(is_valid(check(c, no_angle_bound(), options)));
  options.max_circumradius = std::sqrt(2) * (1 - 1e-15);
  EXPECT_TRUE(reports_only(check(c, no_angle_bound(), options), Kind::large_circumradius));
}

TEST(Check, compares_with_the_cap_of_the_region_a_triangle_lies_in) {
  Case c = testing::square_in_eight();
  c.pslg.regions[1].max_area = 1.5;
  Goal goal = no_angle_bound();
  EXPECT_TRUE(is_valid(check(c, goal)));
  goal.region_caps = true;
  EXPECT_TRUE(reports_only(check(c, goal), Kind::region_area));
  EXPECT_EQ(count(check(c, goal), Kind::region_area), 4u);
}

TEST(Check, names_the_caps_of_the_regions_in_the_line_of_the_goal) {
  Case c = testing::square_in_eight();
  ASSERT_EQ(c.pslg.regions.size(), 2u);
  c.pslg.regions[0].max_area = 3;
  c.pslg.regions[1].max_area = std::numeric_limits<double>::infinity();
  Goal goal = no_angle_bound();
  EXPECT_EQ(to_text(check(c, goal)).find("region"), std::string::npos);
  goal.region_caps = true;
  EXPECT_NE(to_text(check(c, goal)).find("areas up to 3 in region 0, constrained"), std::string::npos);
  c.pslg.regions[1].max_area = 2.5;
  EXPECT_NE(to_text(check(c, goal)).find("areas up to 3 in region 0, 2.5 in region 1, constrained"), std::string::npos);
}

TEST(Check, evaluates_the_sizing_function_at_centroids) {
  const Case c = testing::square_in_eight();
  Goal goal = no_angle_bound();
  goal.size = [](Point p) { return p.x < 2 ? 3.0 : 2.5; };
  EXPECT_TRUE(reports_only(check(c, goal), Kind::size_exceeded));
  EXPECT_EQ(count(check(c, goal), Kind::size_exceeded), 4u);
}

TEST(Check, reports_the_triangles_for_which_the_size_function_has_no_answer) {
  const Case c = testing::square_in_two();
  Goal goal = no_angle_bound();
  for (const double useless : {0.0, -1.0, std::nan("")}) {
    goal.size = [=](Point) { return useless; };
    EXPECT_EQ(count(check(c, goal), Kind::size_exceeded), 2u) << useless;
  }
  goal.size = [](Point p) { return p.x > p.y ? throw std::runtime_error("no data") : 100.0; };
  const Certificate certificate = check(c, goal);
  EXPECT_TRUE(reports_only(certificate, Kind::size_exceeded));
  EXPECT_EQ(count(certificate, Kind::size_exceeded), 1u);
  EXPECT_NE(certificate.violations.at(0).witness.text().find("threw an exception"), std::string::npos);
}

TEST(Check, allows_edges_that_are_longer_than_the_length_limited_by_grading_by_64_units_in_the_last_place) {
  // The size source lies at the centroid of a triangle whose longest edge is 4. Elsewhere longer edges are allowed.
  const double far = 0x1p40, unit = 0x1p-12;
  Case c;
  c.pslg.points = {{far, 0}, {far + 4, 0}, {far + 4, 4}, {far, 4}};
  c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}};
  std::vector<Point> points = c.pslg.points;
  points.push_back({far + 2, 2});
  c.mesh = testing::mesh_of(points, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  const Point centroid{(points[0].x + points[1].x + points[4].x) / 3, (points[0].y + points[1].y + points[4].y) / 3};
  const auto too_large = [&](double size) {
    Goal goal = no_angle_bound();
    goal.grading = 100;
    goal.sources = {{centroid, centroid, size, size}};
    return count(check(c, goal), Kind::size_exceeded);
  };
  EXPECT_EQ(too_large(4 - 63 * unit), 0u);
  EXPECT_EQ(too_large(4 - 65 * unit), 1u);
}

TEST(Check, compares_edges_with_sizes_and_with_a_limit_on_gradation_if_there_are_both) {
  Case c;
  c.pslg.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}};
  std::vector<Point> points = c.pslg.points;
  points.push_back({2, 2});
  c.mesh = testing::mesh_of(points, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  Goal goal = no_angle_bound();
  const auto too_large = [&] { return count(check(c, goal), Kind::size_exceeded); };
  goal.grading = 100;
  goal.sources = {{{2, 2.0 / 3}, {2, 2.0 / 3}, 1, 1}};
  EXPECT_EQ(too_large(), 1u) << "the lowest triangle";
  goal.size = [](Point) { return 100.0; };
  EXPECT_EQ(too_large(), 1u);
  goal.size = [](Point p) { return p.x > 3 ? 1.0 : 100.0; };
  EXPECT_EQ(too_large(), 2u) << "and the one on the right";
}

TEST(Check, takes_bounds_on_edges_and_areas_that_are_infinite_as_no_bounds) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bound : {infinity, -infinity}) {
    const Certificate certificate = check(testing::square_in_two(), Goal{.min_angle_deg = 50, .max_edge = bound});
    EXPECT_TRUE(reports_only(certificate, Kind::small_angle));
    EXPECT_TRUE(
        reports_only(check(testing::square_in_two(), Goal{.min_angle_deg = 50, .max_area = bound}), Kind::small_angle));
  }
}

// Tests of meshes that other programs made.

TEST(Check, matches_the_vertices_of_a_foreign_mesh_by_coordinates) {
  Case c = testing::square_in_eight();
  std::vector<Point> points;
  std::vector<std::array<Index, 3>> triangles;
  for (std::size_t v = 9; v-- > 0;) points.push_back(c.mesh.points[v]);
  for (const Triangle& t : c.mesh.triangles) triangles.push_back({8 - t.v[0], 8 - t.v[1], 8 - t.v[2]});
  c.mesh = testing::mesh_of(points, triangles);
  c.mesh.origin.clear();
  CheckOptions options;
  EXPECT_TRUE(reports(check(c, no_angle_bound(), options), Kind::missing_input_vertex));
  options.foreign = true;
  EXPECT_TRUE(is_valid(check(c, no_angle_bound(), options)));
  for (Triangle& t : c.mesh.triangles) t.n = {no_index, no_index, no_index};
  EXPECT_TRUE(is_valid(check(c, no_angle_bound(), options))) << "neighbours may be absent";
  c.mesh.points[2] = {2 + 1e-7, 2};
  EXPECT_TRUE(reports(check(c, no_angle_bound(), options), Kind::chain_off_segment));
}

TEST(Check, compares_the_markers_of_a_foreign_mesh_with_the_points_at_the_same_places) {
  const Case own = testing::square_in_eight();
  Case c = own;
  const auto renumbered = [](Index v) { return 8 - v; };
  std::vector<std::array<Index, 3>> triangles;
  for (const Triangle& t : own.mesh.triangles)
    triangles.push_back({renumbered(t.v[0]), renumbered(t.v[1]), renumbered(t.v[2])});
  std::vector<Point> points;
  std::vector<int> markers;
  for (Index v = 9; v-- > 0;) {
    points.push_back(own.mesh.points[v]);
    markers.push_back(own.mesh.point_markers[v]);
  }
  c.mesh = testing::mesh_of(points, triangles);
  c.mesh.origin.clear();
  c.mesh.point_markers.append(markers);
  EXPECT_TRUE(is_valid(check(c, no_angle_bound(), {.foreign = true})));
  c.mesh.point_markers[renumbered(0)] = 5;
  EXPECT_TRUE(reports_only(check(c, no_angle_bound(), {.foreign = true}), Kind::wrong_vertex_marker));
}

TEST(Check, matches_the_vertices_of_a_file_by_coordinates_if_only_the_first_is_another_one) {
  Case c = testing::square_in_two();
  c.mesh = testing::mesh_of({{0.5, 0.5}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}, {{0, 4, 1}, {0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
  c.mesh.origin.clear();
  EXPECT_TRUE(is_valid(check(c, no_angle_bound(), {.foreign = true})));
}

TEST(Check, follows_a_segment_in_short_steps_where_a_file_marks_no_edges) {
  // So far from the origin, vertex 4 lies within the rounding distance of segment 0-2, and no edge is marked. The chain
  // passes vertex 4, so the flat triangle lies in the region below.
  const double far = 0x1p52;
  const auto at = [&](double x, double y) { return Point{far + x, far + y}; };
  Case c;
  c.pslg.points = {at(0, 0), at(4, -20), at(8, 0), at(4, 20)};
  c.pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}};
  c.pslg.regions = {{at(4, -10), 7, 1000}, {at(4, 10), 8, 1000}};
  std::vector<Point> points = c.pslg.points;
  points.push_back(at(4, 1));
  c.mesh = testing::mesh_of(points, {{0, 1, 2}, {0, 2, 4}, {4, 2, 3}, {0, 4, 3}});
  c.mesh.origin.clear();
  c.mesh.region.append(std::vector<Index>{0, 0, 1, 1});
  c.mesh.region_attributes = {7, 8};
  EXPECT_TRUE(is_valid(check(c, no_angle_bound(), {.foreign = true})));
  c.mesh.region[1] = 1;
  EXPECT_TRUE(reports_only(check(c, no_angle_bound(), {.foreign = true}), Kind::wrong_region));
}

TEST(Check, takes_edges_of_a_foreign_mesh_as_unmarked_only_if_all_markers_are_zero) {
  Case c = testing::square_in_eight();
  const auto verdict = [&](int marker) {
    for (ConstrainedEdge& e : c.mesh.constrained_edges) e.marker = marker;
    return check(c, no_angle_bound(), {.foreign = true});
  };
  EXPECT_TRUE(is_valid(verdict(0)));
  EXPECT_TRUE(reports_only(verdict(1), Kind::wrong_edge_marker));
}

TEST(Check, accepts_a_mesh_of_Mesh_2_for_its_own_bounds_and_for_no_larger_angle) {
  Case c;
  c.pslg = domains::pipe();
  c.mesh = testing::refined_by_cgal(c.pslg, 0.05);
  CheckOptions options;
  options.foreign = true;
  Goal goal;
  goal.min_angle_deg = 20.6;
  goal.max_edge = 0.05;
  goal.conforming = true;
  EXPECT_TRUE(is_valid(check(c, goal, options)));
  goal.min_angle_deg = 33;
  EXPECT_TRUE(reports_only(check(c, goal, options), Kind::small_angle));
}

// Tests of the certificate.

TEST(Certificate, has_the_extremes_and_their_triangles) {
  const Certificate certificate = check(testing::square_in_eight());
  EXPECT_EQ(certificate.vertices, 9u);
  EXPECT_EQ(certificate.triangles, 8u);
  EXPECT_EQ(certificate.area, 16);
  EXPECT_NEAR(certificate.min_angle_deg.value, 45, 1e-12);
  EXPECT_NEAR(certificate.max_angle_deg.value, 90, 1e-12);
  EXPECT_EQ(certificate.max_area.value, 2);
  EXPECT_EQ(certificate.min_edge.value, 2);
  EXPECT_NEAR(certificate.max_edge.value, std::sqrt(8), 1e-12);
  EXPECT_NEAR(certificate.max_circumradius.value, std::sqrt(2), 1e-12);
  EXPECT_EQ(certificate.max_area.triangle, 0u) << "of several triangles, the first";
  EXPECT_EQ(certificate.min_edge.triangle, 0u);
  EXPECT_EQ(certificate.max_edge.triangle, 0u);
  EXPECT_NEAR(certificate.max_area.where.x, 4.0 / 3, 1e-15) << "the centroid of the triangle";
  EXPECT_NEAR(certificate.max_area.where.y, 2.0 / 3, 1e-15);
  std::uint64_t angles = 0;
  for (const std::uint64_t bin : certificate.angle_histogram) angles += bin;
  EXPECT_EQ(certificate.angle_histogram.size(), 18u);
  EXPECT_EQ(angles, 24u);
  EXPECT_EQ(certificate.digest, digest(testing::square_in_eight().mesh));
}

TEST(Certificate, has_the_measures_of_triangles_far_from_the_origin) {
  Case c;
  c.pslg.points = {{100, 200}, {103, 200}, {103, 204}, {100, 204}};
  c.pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  c.mesh = testing::mesh_of(c.pslg.points, {{0, 1, 2}, {0, 2, 3}});
  c.mesh.constrained_edges = {{0, 1, 0, 1}, {1, 2, 1, 1}, {2, 3, 2, 1}, {3, 0, 3, 1}};
  const Certificate certificate = check(c);
  EXPECT_TRUE(is_valid(certificate));
  EXPECT_EQ(certificate.area, 12);
  EXPECT_EQ(certificate.max_area.value, 6);
  EXPECT_EQ(certificate.min_edge.value, 3);
  EXPECT_EQ(certificate.max_edge.value, 5);
  EXPECT_NEAR(certificate.max_circumradius.value, 2.5, 1e-15);
  EXPECT_NEAR(certificate.max_radius_edge_ratio.value, 2.5 / 3, 1e-15);
  EXPECT_NEAR(certificate.min_angle_deg.value, 36.869897645844021, 1e-13);
  EXPECT_NEAR(certificate.max_angle_deg.value, 90, 1e-13);
  EXPECT_NEAR(certificate.max_area.where.x, 102, 1e-12) << "the centroid of the triangle";
  EXPECT_NEAR(certificate.max_area.where.y, 201 + 1.0 / 3, 1e-12);
}

/// The number of equilateral triangles of a mesh that is one triangle of this height over a base of length 1, `scale`
/// times as large. At the height sqrt(3) / 2 it is equilateral.
std::uint64_t equilateral(double height, double scale) {
  Case c;
  c.pslg.points = {{0, 0}, {scale, 0}, {scale / 2, scale * height}};
  c.pslg.segments = {{0, 1}, {1, 2}, {2, 0}};
  c.mesh = testing::mesh_of(c.pslg.points, {{0, 1, 2}});
  c.mesh.constrained_edges = {{0, 1, 0, 1}, {1, 2, 1, 1}, {2, 0, 2, 1}};
  const Certificate certificate = check(c);
  EXPECT_TRUE(is_valid(certificate));
  return certificate.equilateral;
}

TEST(Certificate, counts_no_triangle_without_length_as_equilateral) {
  Case c;
  c.pslg.points = {{0, 0}, {1, 0}, {0, 1}};
  c.pslg.segments = {{0, 1}, {1, 2}, {2, 0}};
  c.mesh = testing::mesh_of({{0, 0}, {1, 0}, {0, 1}, {0, 0}, {0, 0}}, {{0, 3, 4}});
  const Certificate certificate = check(c);
  EXPECT_FALSE(certificate.valid);
  EXPECT_EQ(certificate.equilateral, 0);
}

TEST(Certificate, counts_triangles_whose_edges_differ_by_one_part_in_a_million) {
  // The legs are sqrt(1/4 + h^2). If h grows by d, they grow by 0.866 d.
  const double height = std::sqrt(0.75), million = 1e-6 / height;
  for (const double scale : {1.0, 3e-150, 2e120}) {
    EXPECT_EQ(equilateral(height, scale), 1) << scale;
    for (const double side : {-1.0, 1.0}) {
      EXPECT_EQ(equilateral(height + side * 0.99 * million, scale), 1) << scale;
      EXPECT_EQ(equilateral(height + side * 1.01 * million, scale), 0) << scale;
    }
  }
}

TEST(Certificate, is_valid_JSON) {
  Case c = testing::square_in_eight();
  c.mesh.region[2] = 0;
  const auto json = nlohmann::json::parse(to_json(check(c)));
  EXPECT_EQ(json["schema"], "pardel.certificate/1");
  EXPECT_EQ(json["valid"], false);
  EXPECT_EQ(json["goal"]["max_area"], nullptr);
  EXPECT_EQ(json["mesh"]["triangles"], 8);
  EXPECT_EQ(json["violation_counts"]["wrong_region"], 1);
  EXPECT_EQ(json["violations"][0]["kind"], "wrong_region");
  EXPECT_EQ(json["angle_histogram"].size(), 18u);
  EXPECT_EQ(json["digest"].get<std::string>().size(), 32u);
}

TEST(Certificate, is_text_with_the_violation_and_its_place) {
  Case c = testing::square_in_two();
  c.pslg.points[2] = c.mesh.points[2] = {1.25, 1};
  const std::string text = to_text(check(c));
  EXPECT_EQ(text.substr(0, 9), "NOT VALID");
  EXPECT_NE(text.find("in-circle determinant"), std::string::npos) << text;
  EXPECT_NE(text.find("(1.25, 1)"), std::string::npos) << text;
  EXPECT_EQ(to_text(check(testing::square_in_two())).substr(0, 6), "valid:");
}

TEST(Certificate, of_two_triangles_is_this_text) {
  Case c;
  c.pslg.points = {{0, 0}, {3, 0}, {3, 1}, {0, 2}};
  c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}};
  c.mesh = testing::mesh_of(c.pslg.points, {{0, 1, 2}, {0, 2, 3}});
  c.mesh.constrained_edges = {{0, 1, 0, 1}, {1, 2, 1, 1}, {2, 3, 2, 1}, {3, 0, 3, 1}};
  EXPECT_EQ(to_text(check(c, {.min_angle_deg = 18, .max_area = 3.5})),
            R"(valid: 4 vertices, 2 triangles, 4 constrained edges
goal: angles of at least 18 degrees, areas up to 3.5, constrained Delaunay
  smallest angle            18.4349       triangle 0 at (0, 0)
  largest angle             90            triangle 0 at (3, 0)
  shortest edge             1             triangle 0 at (3, 0.5)
  longest edge              3.16228       triangle 0 at (1.5, 0.5)
  largest area              3             triangle 1 at (1, 1)
  largest circumradius      1.66667       triangle 1 at (1, 1)
  largest radius / edge     1.58114       triangle 0 at (2, 0.333333)
  area                      4.5
  equilateral triangles     0
angles, in degrees
    0 - 10            0
   10 - 20            1  ################
   20 - 30            0
   30 - 40            1  ################
   40 - 50            0
   50 - 60            0
   60 - 70            0
   70 - 80            3  ##################################################
   80 - 90            0
   90 - 100           1  ################
  100 - 110           0
  110 - 120           0
  120 - 130           0
  130 - 140           0
  140 - 150           0
  150 - 160           0
  160 - 170           0
  170 - 180           0
digest 231d0de57cc053ff3619a02194350965
)");
}

/// A certificate that no check made, with everything that a certificate can contain.
Certificate full_certificate() {
  Certificate certificate;
  certificate.goal = {.min_angle_deg = 20, .max_area = 0.5, .max_edge = 2};
  certificate.goal.region_caps = certificate.goal.conforming = certificate.goal.convex_hull = true;
  certificate.goal.size = [](Point) { return 1.0; };
  for (int r = 0; r < 13; ++r)
    certificate.region_caps.push_back(r == 1 ? std::numeric_limits<double>::infinity() : r + 0.5);
  certificate.vertices = certificate.triangles = certificate.constrained_edges = 1;
  certificate.min_angle_deg = {12.5, 3, {0.25, 4}};
  certificate.area = 2.25;
  certificate.equilateral = 1;
  certificate.decided_exactly = 4;
  certificate.angle_histogram = {1, 0, 100, 200};
  for (Index t = 0; t < 44; ++t)
    certificate.justified.push_back({t, 2 * (t % 22), 60.0 - t, t < 22 ? 9.0 : 8.5 + t / 100.0});
  certificate.violation_counts.assign(violation_kinds, 0);
  certificate.violation_counts[static_cast<std::size_t>(Kind::overlap)] = 1;
  certificate.violation_counts[static_cast<std::size_t>(Kind::small_angle)] = 12;
  certificate.violations = {{Kind::overlap, {7, 8}, {{1, 2}, {3, 4}}, "two things"},
                            {Kind::small_angle, {}, {}, "sharp"}};
  return certificate;
}

TEST(Certificate, names_the_caps_of_ten_regions) {
  Certificate certificate = full_certificate();
  certificate.region_caps.resize(11);
  EXPECT_NE(to_text(certificate).find("9.5 in region 9, 10.5 in region 10, sizes"), std::string::npos);
}

TEST(Certificate, with_everything_is_this_text) {
  EXPECT_EQ(to_text(full_certificate()),
            "NOT VALID: 1 vertex, 1 triangle, 1 constrained edge\n"
            "goal: angles of at least 20 degrees, areas up to 0.5, edges up to 2, areas up to 0.5 in region 0, 2.5 "
            "in region 2, 3.5 in region 3, 4.5 in region 4, 5.5 in region 5, 6.5 in region 6, 7.5 in region 7, 8.5 "
            "in region 8, 9.5 in region 9, 10.5 in region 10 and caps in 2 more, sizes by position, Delaunay, the "
            "convex hull\n"
            "  smallest angle            12.5          triangle 3 at (0.25, 4)\n"
            "  largest angle             0             \n"
            "  shortest edge             0             \n"
            "  longest edge              0             \n"
            "  largest area              0             \n"
            "  largest circumradius      0             \n"
            "  largest radius / edge     0             \n"
            "  area                      2.25\n"
            "  equilateral triangles     1\n"
            "angles, in degrees\n"
            "    0 - 10            1  #\n"
            "   10 - 20            0\n"
            "   20 - 30          100  #########################\n"
            "   30 - 40          200  ##################################################\n"
            "44 triangles below the angle bound, justified by small input angles\n"
            "  at point 0: 2, down to 8.72 degrees, at input angles of 38 to 60\n"
            "  at point 2: 2, down to 8.73 degrees, at input angles of 37 to 59\n"
            "  at point 4: 2, down to 8.74 degrees, at input angles of 36 to 58\n"
            "  at point 6: 2, down to 8.75 degrees, at input angles of 35 to 57\n"
            "  at point 8: 2, down to 8.76 degrees, at input angles of 34 to 56\n"
            "  at point 10: 2, down to 8.77 degrees, at input angles of 33 to 55\n"
            "  at point 12: 2, down to 8.78 degrees, at input angles of 32 to 54\n"
            "  at point 14: 2, down to 8.79 degrees, at input angles of 31 to 53\n"
            "  at point 16: 2, down to 8.8 degrees, at input angles of 30 to 52\n"
            "  at point 18: 2, down to 8.81 degrees, at input angles of 29 to 51\n"
            "  at point 20: 2, down to 8.82 degrees, at input angles of 28 to 50\n"
            "  at point 22: 2, down to 8.83 degrees, at input angles of 27 to 49\n"
            "  at point 24: 2, down to 8.84 degrees, at input angles of 26 to 48\n"
            "  at point 26: 2, down to 8.85 degrees, at input angles of 25 to 47\n"
            "  at point 28: 2, down to 8.86 degrees, at input angles of 24 to 46\n"
            "  at point 30: 2, down to 8.87 degrees, at input angles of 23 to 45\n"
            "  at point 32: 2, down to 8.88 degrees, at input angles of 22 to 44\n"
            "  at point 34: 2, down to 8.89 degrees, at input angles of 21 to 43\n"
            "  at point 36: 2, down to 8.9 degrees, at input angles of 20 to 42\n"
            "  at point 38: 2, down to 8.91 degrees, at input angles of 19 to 41\n"
            "  and at 2 further points\n"
            "digest 00000000000000000000000000000000\n"
            "  overlap                   1\n"
            "  small_angle               12\n"
            "- overlap: two things [ids 7 8] at (1, 2), (3, 4)\n"
            "- small_angle: sharp\n"
            "- and 11 more\n");
}

TEST(Certificate, with_everything_is_this_JSON) {
  Certificate certificate = full_certificate();
  certificate.justified.resize(2);
  certificate.violations[0].ids[1] = no_index;
  EXPECT_EQ(nlohmann::ordered_json::parse(to_json(certificate)), nlohmann::ordered_json::parse(R"({
  "schema": "pardel.certificate/1", "valid": false, "cancelled": false,
  "goal": {"min_angle_deg": 20.0, "max_area": 0.5, "max_edge": 2.0, "region_caps": true, "sizing": true,
           "grading": null, "feature_edges": 0.0,
           "conforming": true, "convex_hull": true},
  "mesh": {"vertices": 1, "triangles": 1, "constrained_edges": 1, "area": 2.25, "equilateral": 1},
  "decided_exactly": 4,
  "extremes": {
    "min_angle_deg": {"value": 12.5, "triangle": 3, "where": [0.25, 4.0]},
    "max_angle_deg": {"value": 0.0, "triangle": null, "where": [0.0, 0.0]},
    "min_edge": {"value": 0.0, "triangle": null, "where": [0.0, 0.0]},
    "max_edge": {"value": 0.0, "triangle": null, "where": [0.0, 0.0]},
    "max_area": {"value": 0.0, "triangle": null, "where": [0.0, 0.0]},
    "max_circumradius": {"value": 0.0, "triangle": null, "where": [0.0, 0.0]},
    "max_radius_edge_ratio": {"value": 0.0, "triangle": null, "where": [0.0, 0.0]}
  },
  "angle_histogram": [1, 0, 100, 200],
  "justified": [{"triangle": 0, "apex": 0, "input_angle_deg": 60.0, "angle_deg": 9.0},
                {"triangle": 1, "apex": 2, "input_angle_deg": 59.0, "angle_deg": 9.0}],
  "not_checked": [],
  "violation_counts": {"overlap": 1, "small_angle": 12},
  "violations": [{"kind": "overlap", "ids": [7, null], "where": [[1.0, 2.0], [3.0, 4.0]], "witness": "two things"},
                 {"kind": "small_angle", "ids": [], "where": [], "witness": "sharp"}],
  "digest": "00000000000000000000000000000000"
})"));
}

TEST(Certificate, that_was_cancelled_says_so) {
  Certificate certificate;
  certificate.cancelled = true;
  certificate.vertices = certificate.triangles = certificate.constrained_edges = 2;
  const std::string text = to_text(certificate);
  EXPECT_EQ(text.substr(0, text.find('\n')), "cancelled: 2 vertices, 2 triangles, 2 constrained edges");
  EXPECT_EQ(text.find("angles, in degrees"), std::string::npos) << "nothing was measured";
  EXPECT_EQ(text.find("triangle "), std::string::npos) << "no triangle has an extreme value";
}

TEST(Certificate, lists_max_violations_of_unused_vertices_and_not_one_more) {
  Case c = testing::square_in_two();
  c.mesh.points.append(std::vector<Point>{{7, 7}, {8, 8}, {9, 9}});
  c.mesh.origin.resize(7, interior_vertex);
  for (const std::size_t most : {0, 1, 2, 3}) {
    const Certificate certificate = check(c, no_angle_bound(), {.max_violations = most});
    EXPECT_EQ(count(certificate, Kind::unused_vertex), 3u);
    EXPECT_EQ(certificate.violations.size(), most);
  }
}

TEST(Certificate, lists_at_most_max_violations_and_counts_all) {
  Goal goal = no_angle_bound();
  goal.max_area = 1e-3;
  CheckOptions options;
  options.max_violations = 3;
  const Certificate certificate = check(testing::square_in_eight(), goal, options);
  EXPECT_EQ(certificate.violations.size(), 3u);
  EXPECT_EQ(count(certificate, Kind::large_area), 8u);
}

/// Two hexagons around one vertex, one turned a little: two closed fans.
TEST(Check, reports_a_vertex_with_two_closed_fans) {
  std::vector<Point> points{{0, 0}};
  const std::vector<Point> corners{{4, 0}, {2, 3}, {-2, 3}, {-4, 0}, {-2, -3}, {2, -3}};
  for (const Point p : corners) points.push_back(p);
  for (const Point p : corners) points.push_back({p.x + p.y / 4, p.y - p.x / 4});
  std::vector<std::array<Index, 3>> triangles;
  for (const Index first : {1U, 7U})
    for (Index i = 0; i < 6; ++i) triangles.push_back({0, first + i, first + (i + 1) % 6});
  Case c;
  c.pslg.points = points;
  c.mesh = testing::mesh_of(points, triangles);
  EXPECT_EQ(count(check(c), Kind::non_manifold_vertex), 1U);
}

TEST(Check, reports_an_unused_vertex_that_comes_first) {
  Case c = testing::square_in_two();
  std::vector<Point> points{{9, 9}};
  for (const Point p : c.mesh.points) points.push_back(p);
  c.mesh = testing::mesh_of(points, {{1, 2, 3}, {1, 3, 4}});
  c.mesh.origin = {};
  const Certificate certificate = check(c, no_angle_bound(), {.foreign = true});
  EXPECT_TRUE(reports_only(certificate, Kind::unused_vertex));
  EXPECT_EQ(certificate.violations[0].ids, std::vector<Index>{0});
}

/// Point 4 lies outside the domain and has no triangle. Vertex 5 is at the same place, and has one.
TEST(Check, takes_the_first_vertices_of_a_foreign_mesh_as_input_points_if_they_are_in_order) {
  Case c = testing::square_in_two();
  c.pslg.points.push_back({5, 5});
  c.pslg.point_markers = {0, 0, 0, 0, 8};
  std::vector<Point> points = c.pslg.points;
  points.insert(points.end(), {{5, 5}, {6, 5}, {5, 6}});
  c.mesh = testing::mesh_of(points, {{0, 1, 2}, {0, 2, 3}, {5, 6, 7}});
  c.mesh.origin = {};
  c.mesh.point_markers.append(std::vector<int>{1, 1, 1, 1, 8, 0, 0, 0});
  EXPECT_EQ(count(check(c, no_angle_bound(), {.foreign = true}), Kind::wrong_vertex_marker), 0U);
  c.mesh.point_markers[4] = 0;
  c.mesh.point_markers[5] = 8;
  EXPECT_EQ(count(check(c, no_angle_bound(), {.foreign = true}), Kind::wrong_vertex_marker), 2U);
}

/// Two vertices of one segment are so close that their distances from its ends are nearly equal.
TEST(Check, takes_all_vertices_of_a_foreign_mesh_as_input_points_if_they_are_the_same) {
  // A point outside the domain stands twice in the input.
  Case c = testing::square_in_two();
  c.pslg.points.insert(c.pslg.points.end(), {{5, 5}, {5, 5}});
  c.mesh = testing::mesh_of(c.pslg.points, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_TRUE(is_valid(check(c, no_angle_bound(), {.foreign = true})));
  c.mesh.points.pop_back();
  c.mesh.origin.pop_back();
  EXPECT_TRUE(is_valid(check(c, no_angle_bound(), {.foreign = true}))) << "by its coordinates";
}

TEST(Check, does_not_justify_a_small_angle_by_two_vertices_of_one_segment) {
  Case c;
  c.pslg.points = {{0, 0}, {1, 0}, {0.5, 0.5}};
  c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 0, 0}};
  std::vector<Point> points = c.pslg.points;
  points.insert(points.end(), {{0.5, 0}, {0.5 + 0x1p-36, 0}});
  c.mesh = testing::mesh_of(points, {{0, 3, 2}, {3, 4, 2}, {4, 1, 2}});
  c.mesh.origin[3] = c.mesh.origin[4] = origin_on_segment(0);
  c.mesh.constrained_edges = {{0, 3, 0, 1}, {3, 4, 0, 1}, {4, 1, 0, 1}, {1, 2, 1, 1}, {2, 0, 2, 1}};
  Goal goal;
  goal.min_angle_deg = 10;
  const Certificate certificate = check(c, goal);
  EXPECT_TRUE(reports_only(certificate, Kind::small_angle));
  EXPECT_TRUE(certificate.justified.empty());
}

}  // namespace
}  // namespace pardel::checker
