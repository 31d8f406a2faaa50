// repair(): the repair of each kind of problem.
#include "../../../parallel/repair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "../../../parallel/gaps.hpp"
#include "../../../parallel/mesher.hpp"
#include "../../../parallel/validate.hpp"
#include "../shapes.hpp"

namespace pardel::engine {
namespace {

using testing::add_polygon;
using testing::add_square;
using testing::square;

using Ids = std::vector<Index>;

/// Expects that the repaired domain is valid.
Repaired repaired(const Pslg& pslg, std::optional<double> snap = 0) {
  Result<Repaired> result = repair(pslg, {.snap = snap});
  EXPECT_TRUE(result.ok()) << result.error().message;
  for (const Problem& p : find_problems(result->domain.pslg())) ADD_FAILURE() << p.message();
  return std::move(result).value();
}

TEST(Repair, leaves_a_valid_domain_as_it_is) {
  Pslg pslg = square(4);
  add_square(pslg, 2, {1, 1}, 7);
  pslg.has_segment_markers = true;
  pslg.attributes_per_point = 1;
  pslg.point_attributes = {1, 2, 3, 4, 5, 6, 7, 8};
  pslg.point_markers = {8, 7, 6, 5, 4, 3, 2, 1};
  pslg.holes = {{2, 2}};
  pslg.regions = {{{0.5, 0.5}, 3, 0.1}};
  const Repaired result = repaired(pslg);
  EXPECT_EQ(result.domain.pslg(), pslg);
  EXPECT_EQ(result.point_map, (Ids{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(result.segment_map, (Ids{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_TRUE(result.log.empty());
}

TEST(Repair, merges_equal_points_and_maps_them) {
  Pslg pslg = square(4);
  pslg.points.insert(pslg.points.begin() + 1, {0, 0});  // 0 and 1 are equal now
  pslg.segments = {{0, 2}, {2, 3}, {3, 4}, {4, 1}};
  pslg.attributes_per_point = 1;
  pslg.point_attributes = {10, 11, 12, 13, 14};
  pslg.point_markers = {5, 6, 7, 8, 9};
  const Repaired result = repaired(pslg);
  EXPECT_EQ(result.point_map, (Ids{0, 0, 1, 2, 3}));
  EXPECT_EQ(result.domain.pslg().points, square(4).points);
  EXPECT_EQ(result.domain.pslg().segments, square(4).segments);
  EXPECT_EQ(result.domain.pslg().point_attributes, (std::vector<double>{10, 12, 13, 14}));
  EXPECT_EQ(result.domain.pslg().point_markers, (std::vector<int>{5, 7, 8, 9}));
}

TEST(Repair, closes_gaps_that_are_smaller_than_the_snapping_distance) {
  Pslg pslg;
  pslg.points = {{0, 0}, {4, 0}, {4.001, 0}, {4, 4}, {4, 4.001}, {0, 0.001}};
  pslg.segments = {{0, 1}, {2, 3}, {4, 5}};
  EXPECT_FALSE(repair(pslg).ok());
  const Repaired result = repaired(pslg, 0.01);
  EXPECT_EQ(result.domain.pslg().points, (std::vector<Point>{{0, 0}, {4, 0}, {4, 4}}));
  EXPECT_EQ(result.point_map, (Ids{0, 1, 1, 2, 2, 0}));
}

TEST(Repair, closes_gaps_of_one_rounding_by_default_and_says_what_moved) {
  Pslg pslg = square(4);
  pslg.points.insert(pslg.points.end(), {{1, 1}, {3, 1 + 4e-15}, {3, 1}, {3, 3}, {4, 4 - 1e-13}, {2, 3.5}});
  pslg.segments.insert(pslg.segments.end(), {{4, 5}, {6, 7}, {8, 9}});
  pslg.first_id = {1};
  const Repaired result = repaired(pslg, std::nullopt);
  EXPECT_EQ(result.snap, 0x1p-38 * 4);
  EXPECT_EQ(result.point_map, (Ids{0, 1, 2, 3, 4, 5, 5, 6, 2, 7}));
  EXPECT_EQ(result.moved_points.count, 2);
  EXPECT_EQ(result.moved_points.farthest, 8);
  EXPECT_EQ(result.moved_points.distance, 4 - (4 - 1e-13));
  EXPECT_EQ(result.bent_segments.count, 0);
  ASSERT_EQ(result.log.size(), 2);
  EXPECT_TRUE(result.log[1].starts_with("Points moved: 2; the farthest, point 9 at (4, 3.9999999999999), moved by"));
}

TEST(Repair, bends_a_segment_to_a_point_one_rounding_beside_it) {
  Pslg pslg = square(4);
  pslg.points.insert(pslg.points.end(), {{1, 1}, {3, 2}, {2, 1.5 + 1e-15}, {2, 3}, {2, 5e-13}, {3, 1}});
  pslg.segments.insert(pslg.segments.end(), {{4, 5}, {6, 7}, {8, 9}});
  EXPECT_EQ(repaired(pslg).domain.pslg(), pslg);  // without snapping it is valid
  const Repaired result = repaired(pslg, std::nullopt);
  EXPECT_EQ(result.domain.pslg().points, pslg.points);
  EXPECT_EQ(result.domain.pslg().segments,
            (std::vector<Segment>{{0, 8}, {8, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 6}, {6, 5}, {6, 7}, {8, 9}}));
  EXPECT_EQ(result.bent_segments.count, 2);
  EXPECT_EQ(result.bent_segments.farthest, 0);
  EXPECT_EQ(result.bent_segments.distance, 5e-13);
  EXPECT_EQ(result.moved_points.count, 0);
}

TEST(Repair, bends_steep_and_flat_segments_alike) {
  for (int degrees = 0; degrees < 180; degrees += 5) {
    const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    Pslg pslg;
    add_square(pslg, 4, {-2, -2});
    pslg.points.insert(pslg.points.end(), {{-c, -s}, {c, s}, {-1e-13 * s, 1e-13 * c}, {-s, c}});
    pslg.segments.insert(pslg.segments.end(), {{4, 5}, {6, 7}});
    EXPECT_EQ(repaired(pslg, std::nullopt).domain.pslg().segments.size(), 7) << degrees;
    EXPECT_EQ(repaired(pslg, 5e-14).domain.pslg().segments.size(), 6) << degrees;
  }
}

TEST(Repair, never_moves_a_segment_over_a_point_without_touching_it) {
  // Point 4 merges into point 0. Its segment then passes on the other side of point 6, at a distance below 0.01.
  Pslg pslg;
  pslg.points = {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0.009, 0}, {10, 0.2}, {0.3, 0.003}};
  pslg.points[6].y = 0.2 / 10 * 0.3 - 0.0001;
  pslg.segments = {{0, 1}, {1, 5}, {5, 2}, {2, 3}, {3, 0}, {4, 5}};
  const double at_point = 0.2 / (10 - 0.009) * (0.3 - 0.009);
  ASSERT_GT(pslg.points[6].y, at_point);        // above the segment from 4 to 5
  ASSERT_LT(pslg.points[6].y, 0.2 / 10 * 0.3);  // below the segment from 0 to 5
  const Repaired result = repaired(pslg, 0.01);
  const Index through = result.point_map[6];
  const auto ends_there = [&](const Segment& s) { return s.a == through || s.b == through; };
  EXPECT_GE(std::ranges::count_if(result.domain.pslg().segments, ends_there), 2);
}

/// A grid of walls that end on other walls, rotated, so that most ends are one rounding beside the walls.
Pslg rotated_walls(int n) {
  const double c = std::cos(0.5), s = std::sin(0.5);
  Pslg pslg;
  const auto add = [&](double x, double y, double to_x, double to_y) {
    const auto first = static_cast<Index>(pslg.points.size());
    pslg.points.insert(pslg.points.end(), {{c * x - s * y, s * x + c * y}, {c * to_x - s * to_y, s * to_x + c * to_y}});
    pslg.segments.push_back({first, first + 1});
  };
  for (int i = 0; i <= n; ++i) {
    add(0, i, n, i);
    for (int j = 0; i < n && j <= n; ++j) add(j, i, j, i + 1);
  }
  return pslg;
}

TEST(Repair, makes_a_rotated_grid_of_t_junctions_meshable_at_30_degrees) {
  constexpr int n = 8;
  const Pslg pslg = rotated_walls(n);
  const Repaired with_gaps = repaired(pslg), without = repaired(pslg, std::nullopt);
  EXPECT_EQ(without.domain.pslg().points.size(), (n + 1) * (n + 1));
  EXPECT_EQ(without.domain.pslg().segments.size(), 2 * n * (n + 1));
  for (const double angle : {20.7, 30.0}) {
    const Result<Meshed> meshed = mesh(without.domain, {.min_angle_deg = angle});
    ASSERT_TRUE(meshed);
    EXPECT_TRUE(meshed->report.goal_met());
    EXPECT_LT(meshed->mesh.triangles.size(), 1000);
  }
  EXPECT_FALSE(mesh(with_gaps.domain, {.min_angle_deg = 20.7})->report.goal_met());
}

TEST(Repair, uses_a_smaller_default_for_a_domain_narrower_than_the_default) {
  Pslg pslg;
  pslg.points = {{1000, 0}, {1001, 0}, {1001, 1e-9}, {1000, 1e-9}, {1000.5, 1e-13}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 2}};
  EXPECT_FALSE(repair(pslg, {.snap = default_snap(pslg)}));
  const Repaired result = repaired(pslg, std::nullopt);
  EXPECT_EQ(result.snap, default_snap(pslg) * 0x1p-4);
  EXPECT_EQ(result.bent_segments.count, 1);
  EXPECT_TRUE(repair(result.domain.pslg())->log.empty());
}

/// Two squares beside each other. The corners of the second are `width` away from the side of the first.
Pslg squares_with_a_slit(double width) {
  Pslg pslg = square(1);
  add_square(pslg, 0.5, {1 + width, 0.25});
  add_square(pslg, 4, {-1, -1});
  return pslg;
}

TEST(Repair, closes_gaps_wider_than_the_default_distance_if_they_are_much_narrower_than_the_segments_around) {
  const Pslg pslg = squares_with_a_slit(0x1p-33);
  EXPECT_GT(0x1p-33, default_snap(pslg));
  const Repaired result = repaired(pslg, std::nullopt);
  EXPECT_EQ(result.snap, 0x1p-32);
  EXPECT_EQ(result.moved_points.count + result.bent_segments.count, 1);
  const Pslg& closed = result.domain.pslg();
  EXPECT_TRUE(find_gaps(result.domain)->empty());
  EXPECT_EQ(closed.segments.size(), 13);  // the side is split at two points, and one piece of it has become double
  EXPECT_TRUE(repaired(closed, std::nullopt).log.empty());
}

TEST(LargestDefaultSnap, is_limited_by_the_coordinates_and_by_the_extent) {
  EXPECT_EQ(largest_default_snap(square(4)), 0x1p-30 * 4);
  Pslg far = square(1);
  for (Point& p : far.points) p.x += 0x1p20;
  EXPECT_EQ(default_snap(far), 0x1p-38 * (0x1p20 + 1));
  EXPECT_EQ(largest_default_snap(far), 1e-6) << "a millionth of the side";
}

TEST(DefaultSnap, does_not_depend_on_a_point_far_outside_of_the_segments) {
  Pslg stray = square(4);
  stray.points.push_back({1e20, -1e20});
  EXPECT_EQ(default_snap(stray), 0x1p-38 * 4);
  EXPECT_EQ(largest_default_snap(stray), 0x1p-30 * 4);
  EXPECT_TRUE(repaired(stray, std::nullopt).log.empty());
  stray.segments.clear();
  EXPECT_EQ(default_snap(stray), 0x1p-38 * 1e20) << "without segments the domain is the hull of its points";
}

TEST(Repair, leaves_small_features_and_wider_gaps_open_by_default) {
  Pslg island = square(1);
  add_square(island, 0x1p-33, {0.5, 0.5});
  EXPECT_TRUE(repaired(island, std::nullopt).log.empty());
  const Pslg slit = squares_with_a_slit(0x1p-25);
  EXPECT_GT(0x1p-25, largest_default_snap(slit));
  EXPECT_TRUE(repaired(slit, std::nullopt).log.empty());
}

TEST(Repair, drops_a_hole_whose_face_closes_and_keeps_the_face_beside_it) {
  Pslg pslg = square(4);
  pslg.points.insert(pslg.points.end(), {{1, 1}, {3, 1}, {3, 1 + 1e-13}, {1, 1 + 1e-13}});
  pslg.segments.insert(pslg.segments.end(), {{4, 5}, {5, 6}, {6, 7}, {7, 4}});
  pslg.holes = {{2, 1 + 5e-14}};
  EXPECT_EQ(repaired(pslg).domain.pslg().holes.size(), 1);
  const Repaired result = repaired(pslg, std::nullopt);
  EXPECT_TRUE(result.domain.pslg().holes.empty());
  EXPECT_TRUE(result.log.back().starts_with("Dropped: Hole 0 at (2, 1.00000000000005) is closer to a segment"));
}

TEST(Repair, drops_a_hole_whose_outline_becomes_a_point) {
  Pslg pslg = square(1000);
  pslg.points.insert(pslg.points.end(), {{500, 500}, {503, 500}, {503, 503}, {500, 503}});
  pslg.segments.insert(pslg.segments.end(), {{4, 5}, {5, 6}, {6, 7}, {7, 4}});
  pslg.holes = {{501, 501}};
  for (const double snap : {3.1, 4.0, 5.0}) {
    const Repaired result = repaired(pslg, snap);
    EXPECT_TRUE(result.domain.pslg().holes.empty()) << snap;
    EXPECT_TRUE(result.log.back().starts_with("Dropped: Hole 0 at (501, 501) lies ")) << result.log.back();
  }
  // A hole beside a crack that becomes a point stays.
  Pslg cracked = square(1000);
  cracked.points.insert(cracked.points.end(), {{300, 300}, {700, 300}, {700, 700}, {300, 700}, {500, 500}, {503, 503}});
  cracked.segments.insert(cracked.segments.end(), {{4, 5}, {5, 6}, {6, 7}, {7, 4}, {8, 9}});
  cracked.holes = {{501, 502}};
  EXPECT_EQ(repaired(cracked, 5).domain.pslg().holes.size(), 1U);
  // A hole beside such a place stays.
  pslg.holes = {{504, 504}};
  pslg.points.insert(pslg.points.end(), {{400, 400}, {600, 400}, {600, 600}, {400, 600}});
  pslg.segments.insert(pslg.segments.end(), {{8, 9}, {9, 10}, {10, 11}, {11, 8}});
  EXPECT_EQ(repaired(pslg, 5).domain.pslg().holes.size(), 1U);
}

TEST(Repair, names_regions_by_their_numbers_in_the_input_also_after_another_one_was_dropped) {
  Pslg pslg = square(4);
  pslg.points.insert(pslg.points.end(), {{1, 1}, {3, 1}, {3, 1 + 1e-13}, {1, 1 + 1e-13}});
  pslg.segments.insert(pslg.segments.end(), {{4, 5}, {5, 6}, {6, 7}, {7, 4}});
  pslg.regions = {{{2, 1 + 5e-14}, 1}, {{2, 2}, 2}, {{2, 3}, 3}};
  const Repaired result = repaired(pslg, std::nullopt);
  EXPECT_EQ(result.domain.pslg().regions, (std::vector<Region>{{{2, 3}, 3}}));
  EXPECT_EQ(result.log.back(), "Dropped: Regions 1 and 2 lie in one face, the second at (2, 3).");
}

TEST(Repair, accepts_an_open_outline_if_the_domain_is_the_convex_hull) {
  Pslg pslg = square(4);
  pslg.segments.pop_back();
  pslg.points.push_back({2, 0});
  EXPECT_FALSE(repair(pslg));
  const Result<Repaired> result = repair(pslg, {.convex_hull = true});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_TRUE(result->domain.convex_hull());
  EXPECT_EQ(result->domain.pslg().segments.size(), 4);
}

TEST(Repair, does_not_snap_points_as_far_apart_as_the_distance) {
  Pslg pslg = square(1);
  EXPECT_EQ(repaired(pslg, 1).domain.pslg(), pslg);
  EXPECT_FALSE(repair(pslg, {.snap = 1.0001}).ok());
}

TEST(Repair, drops_segments_without_length_and_duplicates) {
  Pslg pslg = square(4);
  pslg.segments.insert(pslg.segments.begin(), {{3, 3}, {0, 1}, {1, 0, 9}});
  const Repaired result = repaired(pslg);
  EXPECT_EQ(result.domain.pslg().segments, (std::vector<Segment>{{0, 1, 9}, {1, 2}, {2, 3}, {3, 0}}));
  EXPECT_EQ(result.segment_map, (Ids{1, 4, 5, 6}));
}

TEST(Repair, splits_crossing_segments_and_carries_markers_and_attributes) {
  Pslg pslg = square(4);
  pslg.segments.push_back({0, 2, 5});
  pslg.segments.push_back({1, 3, 6});
  pslg.attributes_per_point = 2;
  pslg.point_attributes = {0, 1, 0, 1, 8, 1, 0, 1};
  pslg.point_markers = {1, 1, 1, 1};
  const Repaired result = repaired(pslg);
  ASSERT_EQ(result.domain.pslg().points.size(), 5);
  EXPECT_EQ(result.domain.pslg().points[4], (Point{2, 2}));
  EXPECT_EQ(result.domain.pslg().point_attributes[8], 4);
  EXPECT_EQ(result.domain.pslg().point_attributes[9], 1);
  EXPECT_EQ(result.domain.pslg().point_markers[4], 5);
  EXPECT_EQ(result.domain.pslg().segments,
            (std::vector<Segment>{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4, 5}, {4, 2, 5}, {1, 4, 6}, {4, 3, 6}}));
  EXPECT_EQ(result.segment_map, (Ids{0, 1, 2, 3, 4, 4, 5, 5}));
}

TEST(Repair, interpolates_attributes_a_quarter_along_a_segment) {
  Pslg pslg = square(4);
  pslg.segments.push_back({0, 2, 5});
  pslg.points.insert(pslg.points.end(), {{0.5, 1.5}, {1.5, 0.5}});
  pslg.segments.push_back({4, 5, 6});  // crosses the diagonal at (1, 1)
  pslg.attributes_per_point = 2;
  pslg.point_attributes = {8, -1, 0, 0, 16, 3, 0, 0, 10, 0, 10, 0};
  const Repaired result = repaired(pslg);
  ASSERT_EQ(result.domain.pslg().points.size(), 7);
  EXPECT_EQ(result.domain.pslg().points[6], (Point{1, 1}));
  EXPECT_NEAR(result.domain.pslg().point_attributes[12], 10, 1e-14) << "three quarters of 8 and a quarter of 16";
  EXPECT_NEAR(result.domain.pslg().point_attributes[13], 0, 1e-14) << "three quarters of -1 and a quarter of 3";
}

TEST(Repair, uses_the_point_that_lies_on_a_crossing) {
  Pslg pslg = square(4);
  pslg.points.push_back({2, 2});
  pslg.segments.push_back({0, 2});
  pslg.segments.push_back({1, 3});
  const Repaired result = repaired(pslg);
  EXPECT_EQ(result.domain.pslg().points, pslg.points);
  EXPECT_EQ(result.domain.pslg().segments.size(), 8);
}

TEST(Repair, splits_segments_at_points_inside_them_in_order) {
  Pslg pslg = square(4);
  pslg.points.insert(pslg.points.end(), {{3, 0}, {1, 0}, {2, 0}});
  const Repaired result = repaired(pslg);
  EXPECT_EQ(result.domain.pslg().points, pslg.points);
  EXPECT_EQ(result.domain.pslg().segments,
            (std::vector<Segment>{{0, 5}, {5, 6}, {6, 4}, {4, 1}, {1, 2}, {2, 3}, {3, 0}}));
}

TEST(Repair, keeps_the_first_of_overlapping_segments) {
  Pslg pslg = square(8);
  pslg.points.insert(pslg.points.end(), {{1, 4}, {5, 4}, {3, 4}, {7, 4}});
  pslg.segments.push_back({4, 5, 2});
  pslg.segments.push_back({7, 6, 3});
  const Repaired result = repaired(pslg);
  EXPECT_EQ(result.domain.pslg().points, pslg.points);
  EXPECT_EQ(result.domain.pslg().segments,
            (std::vector<Segment>{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 6, 2}, {6, 5, 2}, {7, 5, 3}}));
  EXPECT_EQ(result.segment_map, (Ids{0, 1, 2, 3, 4, 4, 5}));
}

TEST(Repair, drops_holes_and_regions_that_have_no_face_of_their_own) {
  Pslg pslg = square(4);
  add_square(pslg, 2, {1, 1});
  pslg.holes = {{9, 9}, {2, 2}, {4, 1}};
  pslg.regions = {{{4, 4}, 1}, {{0.5, 0.5}, 2}, {{0.25, 0.5}, 3}, {{2, 1.5}, 4}, {{-1, 0}, 5}};
  const Repaired result = repaired(pslg);
  EXPECT_EQ(result.domain.pslg().holes, (std::vector<Point>{{2, 2}}));
  EXPECT_EQ(result.domain.pslg().regions, (std::vector<Region>{{{0.25, 0.5}, 3}}));
  EXPECT_EQ(result.log.size(), 6);
}

TEST(Repair, keeps_the_last_of_several_regions_in_one_face) {
  Pslg pslg = square(4);
  pslg.regions = {{{1, 1}, 1, 0.5}, {{2, 2}, 2, 0.25}, {{3, 3}, 3}};
  const Repaired result = repaired(pslg);
  EXPECT_EQ(result.domain.pslg().regions, (std::vector<Region>{{{3, 3}, 3}}));
  EXPECT_EQ(result.log, (std::vector<std::string>{"Dropped: Regions 0 and 1 lie in one face, the second at (2, 2).",
                                                  "Dropped: Regions 1 and 2 lie in one face, the second at (3, 3)."}));
}

TEST(Repair, splits_many_segments_that_cross_near_one_point) {
  Pslg pslg;
  add_square(pslg, 4, {-2, -2});
  for (int i = 0; i < 60; ++i) {
    const double angle = 0.1 + i * 0.05;
    const auto n = static_cast<Index>(pslg.points.size());
    pslg.points.push_back({1.3 * std::cos(angle) + 0.1, 1.3 * std::sin(angle)});
    pslg.points.push_back({-1.3 * std::cos(angle) + 0.1, -1.3 * std::sin(angle)});
    pslg.segments.push_back({n, n + 1});
  }
  repaired(pslg);
  const Repaired snapped = repaired(pslg, 1e-9);
  EXPECT_EQ(snapped.domain.pslg().points.size(), pslg.points.size() + 1);
}

TEST(Repair, logs_every_change) {
  Pslg pslg = square(4);
  pslg.points.insert(pslg.points.end(), {{0, 0}, {2, 0}});
  pslg.segments.insert(pslg.segments.end(), {{0, 4}, {0, 2}, {1, 3}, {2, 0}});
  pslg.holes = {{9, 9}};
  EXPECT_EQ(repaired(pslg).log,
            (std::vector<std::string>{
                "Points merged into others at the same place, or closer than the snapping distance: 1.",
                "Points added where segments cross: 1.",
                "Segments without length dropped: 1.",
                "Segments dropped that others cover: 1.",
                "Segments split where they cross others or have points inside them: 3.",
                "Dropped: Hole 0 at (9, 9) lies outside every closed outline.",
            }));
}

TEST(Repair, refuses_unusable_values_and_domains_without_an_outline) {
  Pslg pslg = square(4);
  pslg.points.push_back({NAN, 0});
  EXPECT_EQ(repair(pslg).error().kind, ErrorKind::invalid_input);
  EXPECT_NE(repair(pslg).error().message.find("Point 4"), std::string::npos);
  pslg.points[4] = {1e300, 0};
  EXPECT_FALSE(repair(pslg).ok());
  pslg = square(4);
  pslg.segments.push_back({0, 4});
  EXPECT_FALSE(repair(pslg).ok());
  pslg = square(4);
  pslg.point_markers = {1};
  EXPECT_FALSE(repair(pslg).ok());
  pslg = square(4);
  pslg.segments.pop_back();
  EXPECT_NE(repair(pslg).error().message.find("outline"), std::string::npos);
  EXPECT_FALSE(repair({}).ok());
}

TEST(Repair, names_the_segment_on_which_a_dropped_region_lies) {
  Pslg pslg = square(4);
  pslg.points.insert(pslg.points.end(), {{1, 1}, {3, 1}});
  pslg.segments.insert(pslg.segments.end(), {{0, 4, 0}, {4, 5, 0}, {5, 1, 0}, {4, 2, 0}, {5, 3, 0}});
  pslg.regions = {{{2, 1}, 1, INFINITY}};
  const std::vector<std::string> log = repaired(pslg).log;
  EXPECT_NE(std::ranges::find(log, "Dropped: Region 0 at (2, 1) lies on segment 5."), log.end());
}

TEST(Repair, refuses_a_snapping_distance_that_is_not_a_length) {
  for (const double snap : {-1.0, static_cast<double>(NAN), static_cast<double>(INFINITY)})
    EXPECT_EQ(repair(square(1), {.snap = snap}).error().kind, ErrorKind::usage);
}

bool keeps_all_parts(const ValidPslg& domain, double snap) { return effect_of_snap(domain, snap)->keeps_all_parts; }

TEST(KeepsAllParts, is_false_for_a_distance_that_removes_a_thin_part_or_a_hole_or_a_region) {
  Pslg thin = square(1);
  add_polygon(thin, {{2, 0}, {3, 0}, {3, 1e-8}, {2, 1e-8}});
  const ValidPslg parts = *validate(thin);
  EXPECT_TRUE(keeps_all_parts(parts, 5e-9));
  EXPECT_FALSE(keeps_all_parts(parts, 2e-8));
  EXPECT_FALSE(keeps_all_parts(*validate(square(1)), 3));

  Pslg hole = square(1);
  add_polygon(hole, {{0.2, 0.5}, {0.8, 0.5}, {0.8, 0.5 + 1e-8}, {0.2, 0.5 + 1e-8}});
  Pslg region = hole;
  hole.holes = {{0.5, 0.5 + 5e-9}};
  region.regions = {{{0.5, 0.5 + 5e-9}, 1, INFINITY}};
  for (const Pslg& pslg : {hole, region}) {
    EXPECT_TRUE(keeps_all_parts(*validate(pslg), 1e-10));
    EXPECT_FALSE(keeps_all_parts(*validate(pslg), 2e-8));
  }
}

/// A side bends to the point of a sliver that is about as far away as the sliver is wide.
TEST(KeepsAllParts, is_false_for_a_distance_that_cuts_a_corner_off) {
  Pslg sliver = square(1);
  sliver.points.push_back({0.125, 0.75});
  sliver.segments.insert(sliver.segments.end(), {{4, 1, 0}, {1, 3, 0}});
  EXPECT_FALSE(keeps_all_parts(*validate(sliver), 0.19));
  EXPECT_TRUE(keeps_all_parts(*validate(sliver), 0.09));
}

TEST(EffectOfSnap, counts_what_merges_and_the_faces) {
  Pslg strip = square(1);
  strip.points.insert(strip.points.end(), {{0.25, 0.5}, {0.75, 0.5}, {0.75, 0.5 + 1e-8}, {0.25, 0.5 + 1e-8}});
  strip.segments.insert(strip.segments.end(), {{4, 5, 0}, {5, 6, 0}, {6, 7, 0}, {7, 4, 0}});
  const SnapEffect none = *effect_of_snap(*validate(strip), 1e-10), closed = *effect_of_snap(*validate(strip), 2e-8);
  EXPECT_EQ(none.points + none.segments, 0U);
  EXPECT_EQ(none.faces_before, 2U);
  EXPECT_EQ(none.faces_after, 2U);
  EXPECT_EQ(none.area, 0);
  EXPECT_TRUE(none.succeeds && none.keeps_all_parts);
  EXPECT_EQ(closed.points, 2U);
  EXPECT_EQ(closed.segments, 3U);
  EXPECT_EQ(closed.faces_after, 1U);
  EXPECT_TRUE(closed.succeeds);
  const SnapEffect nothing_left = *effect_of_snap(*validate(square(1)), 3);
  EXPECT_FALSE(nothing_left.succeeds || nothing_left.keeps_all_parts);
}

TEST(KeepsAllParts, is_true_for_a_distance_that_closes_a_gap_inside_the_domain) {
  Pslg sliver = square(1);
  sliver.points.insert(sliver.points.end(), {{0.25, 1e-8}, {0.75, 1e-8}});
  sliver.segments.push_back({4, 5, 0});
  EXPECT_TRUE(keeps_all_parts(*validate(sliver), 2e-8));
}

/// Segments through nearly one point, whose slopes differ by about 2^-bits: each round of the repair can cause new
/// conflicts.
Pslg bundle(int segments, unsigned seed, int bits) {
  std::mt19937 random(seed);
  const auto within = [&](double most) { return most * (static_cast<double>(random()) * 0x1p-31 - 1); };
  Pslg pslg;
  for (int i = 0; i < segments; ++i) {
    double t = within(1);
    Point centre{100.3, 1000.7};
    if (bits > 0) {
      t = std::ldexp(t, -bits);
      centre.x = 1000.3 + within(0x1p-42);
      centre.y = 1000.7 + within(0x1p-42);
    }
    const double x = (1 - t * t) / (1 + t * t), y = 2 * t / (1 + t * t);
    const double ahead = 1 + within(0.5), behind = 1 + within(0.5);
    const auto first = static_cast<Index>(pslg.points.size());
    pslg.points.push_back({centre.x + ahead * x, centre.y + ahead * y});
    pslg.points.push_back({centre.x - behind * x, centre.y - behind * y});
    pslg.segments.push_back({first, first + 1});
  }
  return pslg;
}

/// How often conflicts may fail to halve, and how far their number may grow, before the repair tries a coarser lattice.
TEST(Repair, of_bundles_of_segments_makes_the_attempts_that_are_recorded) {
  struct Bundle {
    int segments;
    unsigned seed;
    int bits;
    std::size_t points, pieces;
  };
  for (const auto& [segments, seed, bits, points, pieces] : {Bundle{16, 3, 0, 59, 74},
                                                             {6, 8, 21, 32, 40},
                                                             {32, 9, 0, 121, 151},
                                                             {32, 18, 0, 195, 297},
                                                             {8, 5, 10, 29, 28},
                                                             {8, 31, 10, 67, 88},
                                                             {8, 41, 10, 81, 112}}) {
    const Result<Repaired> result = repair(bundle(segments, seed, bits), {.snap = 0, .convex_hull = true});
    ASSERT_TRUE(result) << seed;
    EXPECT_EQ(result->domain.pslg().points.size(), points) << seed;
    EXPECT_EQ(result->domain.pslg().segments.size(), pieces) << seed;
  }
  for (const auto& [segments, seed, bits] : {std::array{8, 9, 10}, {12, 1, 21}, {8, 5, 27}}) {
    EXPECT_FALSE(repair(bundle(segments, static_cast<unsigned>(seed), bits), {.snap = 0, .convex_hull = true})) << seed;
  }
}

/// Holes and regions that the first attempt drops stay dropped, and are named once.
TEST(Repair, by_default_changes_nothing_again_where_a_snapping_distance_fails) {
  int changed_by_zero = 0;
  int succeeded = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    Pslg pslg = bundle(8 + static_cast<int>(seed % 3) * 8, seed, seed % 2 == 0 ? 0 : 21);
    const auto first = static_cast<Index>(pslg.points.size());
    const Point low = seed % 2 == 0 ? Point{95, 995} : Point{995, 995};
    for (const Point corner : {Point{0, 0}, Point{10, 0}, Point{10, 10}, Point{0, 10}})
      pslg.points.push_back({low.x + corner.x, low.y + corner.y});
    for (Index i = 0; i < 4; ++i) pslg.segments.push_back({first + i, first + (i + 1) % 4});
    pslg.holes = {{low.x - 1, low.y}};                                          // outside
    pslg.regions = {{{low.x + 1, low.y + 1}, 1}, {{low.x + 2, low.y + 1}, 2}};  // in one face
    const Result<Repaired> once = repair(pslg);
    if (!once) continue;  // crossings become more and more at every distance
    ++succeeded;
    EXPECT_TRUE(once->domain.pslg().holes.empty()) << seed;
    EXPECT_EQ(once->domain.pslg().regions, std::vector{pslg.regions[1]}) << seed;
    EXPECT_EQ(std::ranges::count_if(once->log, [](const auto& line) { return line.starts_with("Dropped: "); }), 2);
    const Result<Repaired> twice = repair(once->domain.pslg());
    ASSERT_TRUE(twice) << seed;
    EXPECT_TRUE(twice->log.empty()) << seed << ": " << twice->log.front();
    EXPECT_EQ(twice->domain.pslg(), once->domain.pslg()) << seed;
    if (const Result<Repaired> zero = repair(pslg, {.snap = 0}); zero)
      changed_by_zero += repair(zero->domain.pslg())->log.empty() ? 0 : 1;
  }
  EXPECT_GT(succeeded, 20);
  EXPECT_GT(changed_by_zero, 10);  // the default distances matter in these domains
}

}  // namespace
}  // namespace pardel::engine
