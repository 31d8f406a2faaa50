#include "../../../parallel/arithmetic/between_ends.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace pardel::engine {
namespace {

using Values = std::array<double, 2>;

Values between(Point a, const Values& at_a, Point b, const Values& at_b, Point p) {
  Values values{};
  interpolate_between({a, at_a}, {b, at_b}, p, values);
  return values;
}

TEST(BetweenEnds, values_are_linear_along_the_segment) {
  EXPECT_EQ(between({0, 0}, {10, -8}, {4, 0}, {20, 8}, {1, 0}), (Values{12.5, -4}));
  EXPECT_EQ(between({0, 0}, {10, -8}, {4, 0}, {20, 8}, {3, 0}), (Values{17.5, 4}));
  EXPECT_EQ(between({0, 0}, {10, -8}, {4, 4}, {20, 8}, {0, 0}), (Values{10, -8}));
  EXPECT_EQ(between({0, 0}, {10, -8}, {4, 4}, {20, 8}, {4, 4}), (Values{20, 8}));
}

TEST(BetweenEnds, values_do_not_depend_on_the_direction_of_the_segment_and_never_leave_their_range) {
  const Point a{0.1, 0.7}, b{12.3, -5.1};
  const Values at_a{0.1, 1e300}, at_b{0.3, -1e300};
  for (int i = 0; i <= 100; ++i) {
    const Point p{a.x + 0.01 * i * (b.x - a.x), a.y + 0.01 * i * (b.y - a.y) + 1e-16 * (i % 3)};
    const Values values = between(a, at_a, b, at_b, p);
    EXPECT_EQ(values, between(b, at_b, a, at_a, p));
    EXPECT_GE(values[0], at_a[0]);
    EXPECT_LE(values[0], at_b[0]);
    EXPECT_LE(std::abs(values[1]), 1e300);
  }
}

}  // namespace
}  // namespace pardel::engine
