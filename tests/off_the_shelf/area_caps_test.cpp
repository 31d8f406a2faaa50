#include "../../off_the_shelf/meshers/area_caps.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pardel::engine {
namespace {

/// A triangle of area 6 with a longest edge of 5, and one of area 600.
Subdomain two_sizes(const Goal& goal) {
  Subdomain subdomain;
  subdomain.points = {{0, 0}, {4, 0}, {0, 3}, {100, 0}, {140, 0}, {100, 30}};
  subdomain.triangles = {{0, 1, 2}, {3, 4, 5}};
  subdomain.goal = goal;
  return subdomain;
}

/// The area of the equilateral triangle with this edge.
double equilateral(double edge) { return std::sqrt(3.0) / 4 * edge * edge; }

constexpr double a_little = 1e-11;

TEST(AreaCaps, are_infinite_without_bounds) {
  EXPECT_EQ(area_caps(two_sizes({})), (std::vector<double>{INFINITY, INFINITY}));
}

TEST(AreaCaps, are_the_least_of_the_bounds_on_areas) {
  Subdomain subdomain = two_sizes({.max_area = 4});
  subdomain.max_areas = {3, 5};
  const std::vector<double> caps = area_caps(subdomain);
  EXPECT_NEAR(caps[0], 3, a_little);
  EXPECT_NEAR(caps[1], 4, a_little);
  EXPECT_LT(caps[0], 3);
  EXPECT_LT(caps[1], 4);
}

TEST(AreaCaps, stand_for_longest_edges) {
  for (const double cap : area_caps(two_sizes({.max_edge = 2}))) EXPECT_NEAR(cap, equilateral(2), a_little);
}

TEST(AreaCaps, stand_for_sizes_at_centroids) {
  const std::vector<double> caps = area_caps(two_sizes({.size = [](Point p) { return p.x + p.y; }}));
  EXPECT_NEAR(caps[0], equilateral(4. / 3 + 1), a_little);
  EXPECT_NEAR(caps[1], equilateral(340. / 3 + 10), 1e4 * a_little);
}

TEST(AreaCaps, split_triangles_that_are_small_but_too_long) {
  const std::vector<double> caps = area_caps(two_sizes({.max_edge = 4.5}));
  EXPECT_LT(caps[0], 6);
  EXPECT_NEAR(caps[0], 6, a_little);
  EXPECT_NEAR(caps[1], equilateral(4.5), a_little);
}

TEST(AreaCaps, are_positive_for_flat_triangles) {
  Subdomain subdomain = two_sizes({.max_edge = 1});
  subdomain.points[2] = {2, 0};
  EXPECT_GT(area_caps(subdomain)[0], 0);
}

}  // namespace
}  // namespace pardel::engine
