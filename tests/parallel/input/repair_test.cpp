// repair(): the repair of each kind of problem.
#include "../../../parallel/repair.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../../../parallel/validate.hpp"
#include "../shapes.hpp"

namespace pardel::engine {
namespace {

using testing::add_square;
using testing::square;

using Ids = std::vector<Index>;

/// Expects that the repaired domain is valid.
Repaired repaired(const Pslg& pslg, double snap = 0) {
  Result<Repaired> result = repair(pslg, snap);
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

TEST(Repair, does_not_snap_points_as_far_apart_as_the_distance) {
  Pslg pslg = square(1);
  EXPECT_EQ(repaired(pslg, 1).domain.pslg(), pslg);
  EXPECT_FALSE(repair(pslg, 1.0001).ok());
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
  EXPECT_EQ(result.domain.pslg().regions, (std::vector<Region>{{{0.5, 0.5}, 2}}));
  EXPECT_EQ(result.log.size(), 6);
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

TEST(Repair, refuses_a_snapping_distance_that_is_not_a_length) {
  for (const double snap : {-1.0, static_cast<double>(NAN), static_cast<double>(INFINITY)})
    EXPECT_EQ(repair(square(1), snap).error().kind, ErrorKind::usage);
}

}  // namespace
}  // namespace pardel::engine
