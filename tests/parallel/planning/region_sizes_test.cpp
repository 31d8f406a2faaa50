// Lengths in regions: the function for Goal::size, and the borders for Goal::sources.
#include "../../../parallel/planning/region_sizes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pardel {
namespace {

/// Two unit squares side by side, each a region.
Pslg two_squares() {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}, {1, 4}};
  pslg.regions = {{{0.5, 0.5}, 1}, {{1.5, 0.5}, 2}};
  return pslg;
}

TEST(RegionSizes, are_constant_in_each_region) {
  const auto domain = validate(two_squares());
  const auto sizes = region_sizes(*domain, std::vector{0.25, 0.5});
  ASSERT_TRUE(sizes) << sizes.error().message;
  for (const Point p : {Point{0.1, 0.1}, Point{0.9, 0.9}, Point{0.5, 0.3}}) EXPECT_EQ(sizes->size(p), 0.25);
  for (const Point p : {Point{1.1, 0.1}, Point{1.9, 0.9}, Point{1.5, 0.3}}) EXPECT_EQ(sizes->size(p), 0.5);
}

TEST(RegionSizes, have_the_segments_around_a_region_as_borders) {
  const auto domain = validate(two_squares());
  const auto sizes = region_sizes(*domain, std::vector{INFINITY, 0.5});
  ASSERT_TRUE(sizes) << sizes.error().message;
  EXPECT_EQ(sizes->size({0.5, 0.5}), INFINITY);
  ASSERT_EQ(sizes->borders.size(), 4U);
  for (const SizeSource& border : sizes->borders) {
    EXPECT_EQ(border.at_a, 0.5);
    EXPECT_EQ(border.at_b, 0.5);
    EXPECT_GE(std::min(border.a.x, border.b.x), 1);
  }
}

TEST(RegionSizes, of_two_neighbours_have_the_segment_between_them_as_a_border_of_both) {
  const auto domain = validate(two_squares());
  const auto sizes = region_sizes(*domain, std::vector{0.25, 0.5});
  ASSERT_TRUE(sizes) << sizes.error().message;
  EXPECT_EQ(sizes->borders.size(), 8U);
  for (const double length : {0.25, 0.5})
    EXPECT_EQ(std::ranges::count_if(sizes->borders,
                                    [&](const SizeSource& border) {
                                      return border.a.x == 1 && border.b.x == 1 && border.at_a == length;
                                    }),
              1)
        << length;
}

TEST(RegionSizes, need_one_positive_length_per_region) {
  const auto domain = validate(two_squares());
  EXPECT_EQ(region_sizes(*domain, std::vector{1.0}).error().message, "1 lengths for 2 regions");
  EXPECT_EQ(region_sizes(*domain, std::vector{1.0, 0.0}).error().message,
            "the length in region 1 must be positive, not 0");
}

}  // namespace
}  // namespace pardel
