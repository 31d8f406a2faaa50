// Parts of triangles, at which sizes are sampled.
#include "../../../parallel/quality/parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace pardel::engine {
namespace {

Criteria with_size() {
  Goal goal;
  goal.size = [](Point) { return 1.0; };
  return {goal, Placement::off_centre, {}};
}

TEST(Parts, of_a_triangle_are_equally_large_and_cover_it) {
  const Shape whole({0.1, 0.2}, {3.3, 0.7}, {1.9, 4.1});
  for (int divisions = 0; divisions <= 5; ++divisions) {
    double sum = 0, x = 0, y = 0;
    int parts = 0;
    visit_parts(whole, divisions, [&](const Shape& part) {
      EXPECT_NEAR(part.twice_area, std::ldexp(whole.twice_area, -2 * divisions), 1e-12);
      sum += part.twice_area;
      x += part.centroid().x;
      y += part.centroid().y;
      ++parts;
    });
    EXPECT_EQ(parts, 1 << 2 * divisions);
    EXPECT_NEAR(sum, whole.twice_area, 1e-12);
    EXPECT_NEAR(x / parts, whole.centroid().x, 1e-12) << "they are spread evenly";
    EXPECT_NEAR(y / parts, whole.centroid().y, 1e-12);
  }
}

TEST(Parts, do_not_reach_beyond_the_bounding_box_of_the_triangle) {
  const Shape whole({0.1, 0.3}, {0.7, 0.3}, {0.1, 0.9});
  visit_parts(whole, 6, [&](const Shape& part) {
    for (const Point p : part.p) EXPECT_TRUE(p.x >= 0.1 && p.x <= 0.7 && p.y >= 0.3 && p.y <= 0.9);
  });
}

TEST(Parts, are_enough_for_thousands_of_samples_of_a_size_that_depends_on_the_place) {
  for (const std::size_t triangles : {1U, 2U, 50U, 4095U}) {
    const int divisions = divisions_for(with_size(), triangles);
    EXPECT_GE(triangles << 2 * divisions, 4096U);
    EXPECT_LT(triangles << 2 * (divisions - 1), 4096U);
  }
  EXPECT_EQ(divisions_for(with_size(), 4096), 0);
  EXPECT_EQ(divisions_for(with_size(), 0), 0);
  EXPECT_EQ(divisions_for(Criteria({}, Placement::off_centre, {}), 2), 0) << "the same size everywhere";
}

}  // namespace
}  // namespace pardel::engine
