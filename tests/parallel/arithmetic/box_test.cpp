#include "../../../parallel/arithmetic/box.hpp"

#include <gtest/gtest.h>

namespace pardel::engine {
namespace {

constexpr Box box{1, 2, 3, 5};

TEST(Box, is_the_whole_plane_by_default) {
  EXPECT_TRUE(Box{}.is_whole_plane());
  EXPECT_TRUE(Box{}.contains_half_open({-1e300, 1e300}));
  EXPECT_FALSE(box.is_whole_plane());
  EXPECT_FALSE((Box{-INFINITY, -INFINITY, INFINITY, 0}).is_whole_plane());
}

TEST(Box, is_half_open_for_points) {
  EXPECT_TRUE(box.contains_half_open({1, 2}));
  EXPECT_TRUE(box.contains_half_open({2.999, 4.999}));
  EXPECT_FALSE(box.contains_half_open({3, 4}));
  EXPECT_FALSE(box.contains_half_open({2, 5}));
  EXPECT_FALSE(box.contains_half_open({0.999, 4}));
}

TEST(Box, is_closed_for_intersections) {
  EXPECT_TRUE(box.intersects_closed({3, 5, 4, 6}));
  EXPECT_TRUE(box.intersects_closed({1.5, 3, 1.5, 3}));
  EXPECT_FALSE(box.intersects_closed({3.001, 2, 4, 5}));
  EXPECT_FALSE(box.intersects_closed({1, 0, 3, 1.999}));
  EXPECT_FALSE(box.intersects_closed(empty_box));
}

TEST(Box, covers_points_in_any_order) {
  Box all = empty_box;
  all.cover(Box::around({4, -1}));
  all.cover(Box::around({2, 7}, {3, 0}));
  all.cover(empty_box);
  EXPECT_EQ(all.min_x, 2);
  EXPECT_EQ(all.min_y, -1);
  EXPECT_EQ(all.max_x, 4);
  EXPECT_EQ(all.max_y, 7);
}

TEST(Box, has_its_longer_side_as_extent) {
  EXPECT_EQ(box.extent(), 3);
  EXPECT_EQ((Box{-4, 1, 3, 2}).extent(), 7);
}

TEST(Box, has_a_largest_magnitude_on_any_side) {
  EXPECT_EQ(box.largest_magnitude(), 5);
  EXPECT_EQ((Box{1, 2, 6, 5}).largest_magnitude(), 6);
  EXPECT_EQ((Box{-7, 2, 6, 5}).largest_magnitude(), 7);
  EXPECT_EQ((Box{-7, -8, 6, 5}).largest_magnitude(), 8);
}

TEST(Box, that_ends_on_any_side_is_not_the_whole_plane) {
  EXPECT_FALSE((Box{0, -INFINITY, INFINITY, INFINITY}).is_whole_plane());
  EXPECT_FALSE((Box{-INFINITY, 0, INFINITY, INFINITY}).is_whole_plane());
  EXPECT_FALSE((Box{-INFINITY, -INFINITY, 0, INFINITY}).is_whole_plane());
  EXPECT_FALSE((Box{-INFINITY, -INFINITY, INFINITY, 0}).is_whole_plane());
}

}  // namespace
}  // namespace pardel::engine
