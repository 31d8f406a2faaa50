// The bounds on circumradii, and the largest circumradius of a mesh.
#include "../../../parallel/triangulation/radii.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../samples.hpp"

namespace pardel::engine {
namespace {

/// The circumradius of a triangle, its ratio to the shortest edge, and the area.
Radii measured(Point a, Point b, Point c) {
  const auto distance = [](Point p, Point q) { return std::hypot(p.x - q.x, p.y - q.y); };
  const double x = distance(a, b), y = distance(b, c), z = distance(c, a);
  const double area = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
  const double radius = x * y * z / (4 * area);
  return {radius, radius / std::min({x, y, z}), area};
}

/// The isosceles triangle with two shortest edges has the least area of all triangles with its ratio and circumradius.
TEST(RadiusBound, is_attained_by_the_isosceles_triangle) {
  for (const double least_angle : {5.0, 20.0, 45.0, 59.0}) {
    const double angle = least_angle * std::acos(-1.0) / 180;
    const Radii r = measured({-std::cos(angle), 0}, {std::cos(angle), 0}, {0, std::sin(angle)});
    EXPECT_NEAR(sharp_radius_bound(r.ratio, r.area), r.radius, 1e-9 * r.radius);
    EXPECT_GT(radius_bound(r.ratio, r.area), r.radius);
  }
}

TEST(RadiusBound, of_t3_is_attained_by_the_equilateral_triangle) {
  const Radii r = measured({0, 0}, {1, 0}, {0.5, std::sqrt(0.75)});
  EXPECT_NEAR(radius_bound(r.ratio, r.area), r.radius, 1e-9);
  EXPECT_NEAR(sharp_radius_bound(r.ratio, r.area), r.radius, 1e-9);
}

TEST(LargestRadii, are_those_of_some_triangle_wherever_it_is) {
  const Triangulation whole = samples::triangulated(samples::uniform_points(30, 5)).triangulation;
  const auto count = static_cast<Index>(whole.slots.size());
  // Tests parts of the mesh: each part ends with another triangle. In some parts the last triangle is the largest.
  for (TriangleId last = 0; last < count; ++last) {
    Radii expected;
    for (TriangleId id = 0; id <= last; ++id) {
      const auto [a, b, c] = whole.slots[id].v;
      const Radii r = measured(whole.points[a], whole.points[b], whole.points[c]);
      expected = {std::max(expected.radius, r.radius), std::max(expected.ratio, r.ratio),
                  std::max(expected.area, r.area)};
    }
    const Radii found = largest_radii(whole, IndexAllocator(last + 1, count), 1);
    EXPECT_NEAR(found.radius, expected.radius, 1e-9 * expected.radius);
    EXPECT_NEAR(found.ratio, expected.ratio, 1e-9 * expected.ratio);
    EXPECT_NEAR(found.area, expected.area, 1e-9 * expected.area);
  }
}

/// The slot of an unused index holds no triangle of the mesh.
TEST(LargestRadii, ignore_unused_indices) {
  Triangulation t;
  for (const Point p : {Point{0, 0}, Point{1, 0}, Point{0, 1}, Point{1000, 0}}) t.points.push_back(p);
  t.slots.push_back({{0, 1, 2}, {}});
  t.slots.push_back({{0, 3, 2}, {}});
  t.slots.push_back({{0, 1, 2}, {}});
  IndexAllocator ledger(0, 10);
  std::vector<IndexRange> all;
  ledger.allocate(3, all);
  EXPECT_GT(largest_radii(t, ledger, 1).radius, 400);
  ledger.release(IndexPool({{1, 2}}));
  ledger.settle();
  EXPECT_NEAR(largest_radii(t, ledger, 1).radius, std::sqrt(0.5), 1e-12);
}

}  // namespace
}  // namespace pardel::engine
