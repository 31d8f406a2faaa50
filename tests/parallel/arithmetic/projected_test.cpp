#include "../../../parallel/arithmetic/projected.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pardel::engine {
namespace {

TEST(Projected, leaves_a_point_of_the_line_where_it_is) {
  const Point p = projected({0.5, 0.25}, {0, 0}, {2, 1});
  EXPECT_EQ(p.x, 0.5);
  EXPECT_EQ(p.y, 0.25);
}

TEST(Projected, moves_a_point_at_a_right_angle_onto_the_line) {
  const Point p = projected({1, 1}, {0, 0}, {4, 0});
  EXPECT_EQ(p.x, 1);
  EXPECT_EQ(p.y, 0);
}

TEST(Projected, removes_the_rounding_of_a_point_far_from_the_origin) {
  const Point a{1e6, 1e6}, b{1e6 + 3, 1e6 + 7};
  const Point rounded{std::lerp(a.x, b.x, 0.3) + 4e-10, std::lerp(a.y, b.y, 0.3)};
  const Point p = projected(rounded, a, b);
  const double beside = ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / std::hypot(b.x - a.x, b.y - a.y);
  EXPECT_LE(std::abs(beside), 1.2e-10);  // a unit in the last place of the coordinates
  EXPECT_NEAR(p.x, rounded.x, 1e-9);
}

}  // namespace
}  // namespace pardel::engine
