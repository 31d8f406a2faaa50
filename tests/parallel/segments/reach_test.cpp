// How near points and segments may come before a repair brings them together.
#include "../../../parallel/segments/reach.hpp"

#include <gtest/gtest.h>

namespace pardel::engine {
namespace {

const std::vector<Point> points{{0, 0}, {0x1p50, 0}, {1, -2}, {0.5, 0}, {0.25, 0.5}, {16, 0}, {0x1p60, 1}};
const std::vector<Segment> segments{{0, 1}, {0, 2}, {2, 3}};

TEST(Reach, has_the_scale_of_a_segment_from_its_own_ends) {
  const Reach reach(Snapping::share_of_scale(0.125), points, segments);
  EXPECT_EQ(reach.scale_of_segment(0), 0x1p50);
  EXPECT_EQ(reach.scale_of_segment(1), 2);
  EXPECT_EQ(reach.scale_of_segment(2), 2);
}

TEST(Reach, has_the_scale_of_a_point_from_the_segment_with_the_smallest_scale) {
  const Reach reach(Snapping::share_of_scale(0.125), points, segments);
  EXPECT_EQ(reach.scale_of_point(0), 2);
  EXPECT_EQ(reach.scale_of_point(1), 0x1p50);
  EXPECT_EQ(reach.scale_of_point(3), 2);
}

TEST(Reach, gives_a_point_without_segments_the_next_larger_scale_of_a_segment) {
  const Reach reach(Snapping::share_of_scale(0.125), points, segments);
  EXPECT_EQ(reach.scale_of_point(4), 2);
  EXPECT_EQ(reach.scale_of_point(5), 0x1p50);
  EXPECT_EQ(reach.scale_of_point(6), 0x1p60) << "there is none";
  EXPECT_EQ(reach.scale_of_place({2, 2}), 2);
  EXPECT_EQ(reach.scale_of_place({2, 2.5}), 0x1p50);
}

TEST(Reach, compares_points_without_segments_by_their_own_coordinates) {
  const Reach reach(Snapping::share_of_scale(0.125), points, segments);
  EXPECT_EQ(reach.scale_of_points(4, 5), 2);
  EXPECT_EQ(reach.scale_of_points(5, 5), 16);
  EXPECT_EQ(reach.scale_of_points(5, 1), 0x1p50);
}

TEST(Reach, counts_the_smaller_of_two_scales) {
  const Reach reach(Snapping::share_of_scale(0.125), points, segments);
  EXPECT_EQ(reach.between(2, 0x1p50), 0.25);
  EXPECT_EQ(reach.between(0x1p50, 2), 0.25);
  EXPECT_EQ(reach.between_points(0, 1), 0.25);
  EXPECT_EQ(reach.farthest(0x1p50), 0x1p47);
  EXPECT_EQ(reach.largest(), 0x1p47);
}

TEST(Reach, gives_a_crossing_the_smaller_scale_of_the_two_segments) {
  Reach reach(Snapping::share_of_scale(0.125), points, segments);
  reach.add_crossing(0, 2);
  EXPECT_EQ(reach.scale_of_point(7), 2);
  EXPECT_EQ(reach.between_points(7, 1), 0.25);
}

TEST(Reach, is_the_same_everywhere_for_a_given_distance) {
  const Reach reach(3, points, segments);
  EXPECT_EQ(reach.between_points(0, 1), 3);
  EXPECT_EQ(reach.between(reach.scale_of_place({0x1p80, 0}), reach.scale_of_segment(1)), 3);
  EXPECT_EQ(reach.largest(), 3);
  EXPECT_FALSE(reach.is_zero());
  EXPECT_TRUE(Reach(0, points, segments).is_zero());
}

TEST(Snapping, is_wider_at_scales_with_one_power_of_two_only) {
  Snapping snapping = Snapping::share_of_scale(0.125);
  snapping.widen(2, 4);
  snapping.widen(3, 1);
  EXPECT_EQ(snapping.at(1.5), 0.1875);
  EXPECT_EQ(snapping.at(2), 4);
  EXPECT_EQ(snapping.at(3.5), 4);
  EXPECT_EQ(snapping.at(4), 0.5);
  EXPECT_EQ(snapping.largest_up_to(1.5), 0.1875);
  EXPECT_EQ(snapping.largest_up_to(8), 4);
}

}  // namespace
}  // namespace pardel::engine
