#include "../../../parallel/quality/split_candidates.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../samples.hpp"

namespace pardel::engine {
namespace {

Shape some_triangle(samples::Random& random) {
  for (;;) {
    const auto point = [&] { return Point{random.uniform(-1, 1), random.uniform(-1, 1)}; };
    const Shape shape(point(), point(), point());
    if (shape.twice_area > 0.05) return shape;
  }
}

Point circumcentre(const Shape& s) {
  const double bx = s.p[1].x - s.p[0].x, by = s.p[1].y - s.p[0].y, cx = s.p[2].x - s.p[0].x, cy = s.p[2].y - s.p[0].y;
  const double d = 2 * (bx * cy - by * cx), b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  return {s.p[0].x + (b2 * cy - c2 * by) / d, s.p[0].y + (c2 * bx - b2 * cx) / d};
}

TEST(SplitCandidates, lie_evenly_on_three_circles_and_the_first_one_towards_the_corner_at_the_smallest_angle) {
  samples::Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Shape shape = some_triangle(random);
    const Point o = circumcentre(shape), apex = shape.p[shape.shortest_side()];
    const double radius = std::sqrt(shape.squared_circumradius()), slack = 1e-11 * radius;
    const auto circles = split_candidates(shape);
    for (std::size_t circle = 0; circle < circles.size(); ++circle) {
      const double part = 0.25 * static_cast<double>(circle + 1);
      const Point first{o.x + part * (apex.x - o.x), o.y + part * (apex.y - o.y)};
      EXPECT_NEAR(circles[circle][0].x, first.x, slack);
      EXPECT_NEAR(circles[circle][0].y, first.y, slack);
      const double step = 2 * part * radius * std::sin(std::acos(-1) / candidates_per_circle);
      for (std::size_t k = 0; k < candidates_per_circle; ++k) {
        const Point p = circles[circle][k], next = circles[circle][(k + 1) % candidates_per_circle];
        EXPECT_NEAR(std::hypot(p.x - o.x, p.y - o.y), part * radius, slack);
        EXPECT_NEAR(std::hypot(next.x - p.x, next.y - p.y), step, slack);
        const double turn = (p.x - o.x) * (next.y - o.y) - (p.y - o.y) * (next.x - o.x);
        EXPECT_GT(turn, 0) << "counter-clockwise";
      }
    }
  }
}

TEST(SplitCandidates, scale_with_the_triangle) {
  samples::Random random(2);
  const Shape shape = some_triangle(random);
  const auto scaled = [](Point p) { return Point{0x1p9 * p.x, 0x1p9 * p.y}; };
  const auto small = split_candidates(shape);
  const auto large = split_candidates({scaled(shape.p[0]), scaled(shape.p[1]), scaled(shape.p[2])});
  for (std::size_t circle = 0; circle < small.size(); ++circle)
    for (std::size_t k = 0; k < candidates_per_circle; ++k) EXPECT_EQ(large[circle][k], scaled(small[circle][k]));
}

TEST(LeastSquaredDistance, follows_the_least_of_the_circumradius_and_the_shortest_side) {
  const Shape equilateral({0, 0}, {2, 0}, {1, std::sqrt(3)});
  EXPECT_NEAR(least_squared_distance(equilateral), 0.6 * 4.0 / 3, 1e-12) << "the circumradius is the lesser";
  const Shape right({0, 0}, {2, 0}, {0, 0.5});
  EXPECT_NEAR(least_squared_distance(right), 0.6 * 0.25, 1e-12) << "the shortest side is the lesser";
}

}  // namespace
}  // namespace pardel::engine
