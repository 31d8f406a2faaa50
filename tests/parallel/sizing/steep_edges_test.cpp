// The limit on gradation of a piecewise linear field starts from the edges of its steep triangles.
#include "../../../parallel/sizing/steep_edges.hpp"

#include <gtest/gtest.h>

#include "../../../parallel/sizing/background.hpp"
#include "../../../parallel/sizing/size_envelope.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const std::vector<std::array<Index, 3>> halves{{0, 1, 2}, {0, 2, 3}};

TEST(SteepEdges, of_a_field_that_grows_slowly_are_the_boundary) {
  EXPECT_EQ(steep_edges(square, halves, std::vector<double>{1, 1.1, 1.2, 1.1}, 0.2).size(), 4U);
}

TEST(SteepEdges, of_a_steep_triangle_are_its_three_sides) {
  const auto edges = steep_edges(square, halves, std::vector<double>{1, 1.5, 1.2, 1.1}, 0.2);
  EXPECT_EQ(edges.size(), 5U) << "the diagonal, too";
}

TEST(SteepEdges, limit_the_field_like_all_points_of_all_triangles) {
  samples::Random random(3);
  std::vector<Point> points;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<double> values;
  constexpr Index n = 6;
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      points.push_back({i + random.uniform(-0.3, 0.3), j + random.uniform(-0.3, 0.3)});
      values.push_back(i < 3 ? 1 + 0.05 * i : random.uniform(0.2, 3));
      if (i + 1 == n || j + 1 == n) continue;
      const Index v = j * n + i;
      triangles.push_back({v, v + 1, v + n + 1});
      triangles.push_back({v, v + n + 1, v + n});
    }
  const Background background(points, triangles);
  const double grading = 0.3;
  const auto edges = steep_edges(points, triangles, values, grading);
  std::vector<PreparedSize> cones;
  for (const SizeSource& edge : edges) cones.emplace_back(GrowingSize{edge, grading});
  for (int trial = 0; trial < 100; ++trial) {
    const Point p{random.uniform(0.5, n - 1.5), random.uniform(0.5, n - 1.5)};
    double limited = background.interpolate(p, values), least = INFINITY;
    for (const PreparedSize& cone : cones) limited = std::min(limited, cone.at(p));
    constexpr int steps = 24;
    for (const auto& [a, b, c] : triangles)
      for (int i = 0; i <= steps; ++i)
        for (int j = 0; i + j <= steps; ++j) {
          const double u = double(i) / steps, w = double(j) / steps, rest = 1 - u - w;
          const double x = u * points[a].x + w * points[b].x + rest * points[c].x - p.x;
          const double y = u * points[a].y + w * points[b].y + rest * points[c].y - p.y;
          least =
              std::min(least, u * values[a] + w * values[b] + rest * values[c] + grading * std::sqrt(x * x + y * y));
        }
    EXPECT_LE(limited, least + 1e-12);
    EXPECT_GE(limited, least - 0.1) << "the places above are up to a tenth apart";
  }
}

}  // namespace
}  // namespace pardel::engine
