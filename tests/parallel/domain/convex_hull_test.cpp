// The convex hull and the test for collinear points.
#include "../../../parallel/domain/convex_hull.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pardel::engine {
namespace {

TEST(ConvexHull, includes_the_points_on_its_sides) {
  const std::vector<Point> points{{2, 2}, {4, 0}, {0, 0}, {2, 0}, {4, 4}, {0, 4}, {4, 2}, {0, 1}, {4, 4}, {1, 2}};
  EXPECT_EQ(convex_hull(points), (std::vector<Index>{2, 3, 1, 6, 4, 5, 7}));
}

TEST(ConvexHull, is_exact_where_rounding_would_lose_a_corner) {
  const double y = std::nextafter(0.3, 0.0);
  const std::vector<Point> points{{0.1, 0.1}, {0.3, y}, {0.7, 0.7}, {0, 1}};
  EXPECT_EQ(convex_hull(points), (std::vector<Index>{3, 0, 1, 2}));
}

TEST(ConvexHull, recognises_points_on_one_line) {
  EXPECT_TRUE(all_collinear({}));
  EXPECT_TRUE(all_collinear(std::vector<Point>{{1, 1}, {1, 1}, {2, 3}}));
  EXPECT_TRUE(all_collinear(std::vector<Point>{{0.1, 0.1}, {0.3, 0.3}, {0.7, 0.7}}));
  EXPECT_FALSE(all_collinear(std::vector<Point>{{0.1, 0.1}, {0.3, std::nextafter(0.3, 1.0)}, {0.7, 0.7}}));
}

}  // namespace
}  // namespace pardel::engine
