// The bounds of a goal are compared exactly: each holds at the value that is attained and fails at the next double.
#include <cmath>
#include <limits>

#include "../../../properties/checker/check.hpp"
#include "../../../properties/theorems/framework/property.hpp"
#include "meshes.hpp"
#include "verdicts.hpp"

namespace pardel::checker {
namespace {

using Kind = ViolationKind;
using testing::Case;
using testing::count;
using testing::is_valid;
using testing::no_angle_bound;
using testing::reports_only;

double below(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }
double above(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }

/// The isosceles trapezoid (0, 0), (5, 0), (4, 2), (1, 2) in two triangles. The side of length 5 is longer than the
/// diagonal. It is side `position` of triangle `t`.
Case trapezoid(std::size_t t, std::size_t position) {
  Case c;
  c.pslg.points = {{0, 0}, {5, 0}, {4, 2}, {1, 2}};
  c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}};
  std::array<Index, 3> with_long_side{2, 0, 1};
  std::rotate(with_long_side.begin(), with_long_side.begin() + static_cast<std::ptrdiff_t>((3 - position) % 3),
              with_long_side.end());
  std::vector<std::array<Index, 3>> triangles{with_long_side, {0, 2, 3}};
  if (t == 1) std::swap(triangles[0], triangles[1]);
  c.mesh = testing::mesh_of(c.pslg.points, triangles);
  c.mesh.constrained_edges = {{0, 1, 0, 1}, {1, 2, 1, 1}, {2, 3, 2, 1}, {3, 0, 3, 1}};
  return c;
}

PARDEL_FACT(Bound, on_edges_is_exact_on_the_boundary_and_inside,
            {.statement = "a bound on edge lengths is broken if and only if an edge is longer, also if this edge is an "
                          "edge of the boundary and all others are shorter, and also if it is an edge inside",
             .source = "properties/checker/stages/check_goal.cpp",
             .families = "a trapezoid whose longest edge is a side, as each side of each triangle; a square whose "
                         "longest edge is the diagonal"}) {
  const auto expect = [&](const Case& c, double bound, std::uint64_t long_edges) {
    Goal goal = no_angle_bound();
    goal.max_edge = bound;
    const Certificate certificate = check(c, goal);
    EXPECT_EQ(count(certificate, Kind::long_edge), long_edges) << bound << ": " << to_text(certificate);
    EXPECT_EQ(certificate.valid, long_edges == 0);
    ++facts.cases;
  };
  for (const std::size_t t : {0U, 1U})
    for (const std::size_t position : {0U, 1U, 2U}) {
      expect(trapezoid(t, position), 5, 0);
      expect(trapezoid(t, position), below(5), 1);
    }
  const double diagonal = std::sqrt(2.0);  // rounded upward
  expect(testing::square_in_two(), diagonal, 0);
  expect(testing::square_in_two(), below(diagonal), 1);
}

PARDEL_FACT(Bound, of_the_sizing_function_is_exact,
            {.statement = "a triangle has a size_exceeded if and only if one of its edges is longer than the sizing "
                          "function at its rounded centroid; the comparison is exact",
             .source = "properties/checker/check.hpp",
             .families = "a trapezoid and a square; sizes equal to the longest edge, and the next double below"}) {
  const auto expect = [&](const Case& c, double size, std::uint64_t exceeded) {
    Goal goal = no_angle_bound();
    goal.size = [=](Point) { return size; };
    const Certificate certificate = check(c, goal);
    EXPECT_EQ(count(certificate, Kind::size_exceeded), exceeded) << size << ": " << to_text(certificate);
    ++facts.cases;
  };
  for (const std::size_t t : {0U, 1U})
    for (const std::size_t position : {0U, 1U, 2U}) {
      expect(trapezoid(t, position), 5, 0);
      expect(trapezoid(t, position), below(5), 1);
    }
  expect(testing::square_in_two(), std::sqrt(2.0), 0);
  expect(testing::square_in_two(), below(std::sqrt(2.0)), 2);
  expect(testing::square_in_two(), std::numeric_limits<double>::infinity(), 0);
  expect(testing::square_in_two(), std::numeric_limits<double>::max(), 0);
  expect(testing::square_in_two(), std::numeric_limits<double>::denorm_min(), 2);

  // The function is evaluated at the centroid, not near it.
  Goal goal = no_angle_bound();
  const Point centroid{(0.0 + 1 + 1) / 3, (0.0 + 0 + 1) / 3}, other{(0.0 + 1 + 0) / 3, (0.0 + 1 + 1) / 3};
  goal.size = [=](Point p) { return p == centroid || p == other ? 2.0 : 0.0; };
  EXPECT_TRUE(is_valid(check(testing::square_in_two(), goal)));
  ++facts.cases;
}

PARDEL_FACT(Bound, on_angles_is_exact_for_the_rounded_cosine,
            {.statement = "an angle is too small if and only if its exact cosine is greater than the double that "
                          "angle_cosine_bound() computes for the bound",
             .source = "properties/checker/tolerances.hpp",
             .families = "angles of 45 degrees, bounds up to 64 units in the last place above and below"}) {
  const Case c = testing::square_in_two();
  double greatest_broken = 0, least_kept = 1;
  double bound = 45 * (1 - 32 * 0x1p-52);
  for (int i = 0; i < 128; ++i, bound = above(bound)) {
    Goal goal;
    goal.min_angle_deg = bound;
    const double cosine = angle_cosine_bound(bound);
    const bool kept = std::fma(cosine, cosine, -0.5) >= 0;  // exact: cos 45 degrees is the root of 1/2
    const Certificate certificate = check(c, goal);
    EXPECT_EQ(certificate.valid, kept) << bound;
    EXPECT_EQ(count(certificate, Kind::small_angle), kept ? 0U : 2U) << bound;
    if (kept)
      least_kept = std::min(least_kept, cosine);
    else
      greatest_broken = std::max(greatest_broken, cosine);
    ++facts.cases;
  }
  EXPECT_LE(least_kept - greatest_broken, 4 * 0x1p-53) << "these two cosines are neighbours or nearly so";
}

PARDEL_FACT(Bound, on_angles_is_the_rounded_cosine_of_the_bound,
            {.statement = "angle_cosine_bound() is the cosine to within 2^-51; it is 1 for "
                          "bounds that are not positive, and the cosine of 90 degrees for larger bounds",
             .source = "properties/checker/tolerances.hpp",
             .families = "bounds from 0 to 90 degrees in steps of 1/64"}) {
  constexpr long double degree = 3.14159265358979323846264338327950288L / 180;
  for (int i = 1; i <= 90 * 64; ++i, ++facts.cases) {
    const double bound = i / 64.0;
    EXPECT_NEAR(angle_cosine_bound(bound), static_cast<double>(std::cos(bound * degree)), 0x1p-51) << bound;
  }
  for (const double none : {0.0, -0.0, -1.0, -45.0, std::nan("")}) EXPECT_EQ(angle_cosine_bound(none), 1) << none;
  EXPECT_LT(angle_cosine_bound(1e-6), 1);
  for (const double large : {above(90.0), 91.0, 180.0, 360.0})
    EXPECT_EQ(angle_cosine_bound(large), angle_cosine_bound(90)) << large;
}

PARDEL_FACT(Bound, on_areas_and_circumradii_is_exact,
            {.statement = "bounds on areas, areas in a region and circumradii hold at the largest value of the mesh "
                          "and are broken at the next smaller double",
             .source = "properties/checker/stages/check_goal.cpp",
             .families = "a right triangle with the sides 3, 4 and 5"}) {
  Case c;
  c.pslg.points = {{0, 0}, {4, 0}, {0, 3}};
  c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 0, 0}};
  c.pslg.regions = {{{1, 1}, 7, 6}};
  c.mesh = testing::mesh_of(c.pslg.points, {{0, 1, 2}});
  c.mesh.constrained_edges = {{0, 1, 0, 1}, {1, 2, 1, 1}, {2, 0, 2, 1}};
  c.mesh.region.push_back(0);
  c.mesh.region_attributes = {7};
  Goal goal = no_angle_bound();
  goal.region_caps = true;
  goal.max_area = 6;
  CheckOptions options;
  options.max_circumradius = 2.5;
  EXPECT_TRUE(is_valid(check(c, goal, options)));
  Goal smaller = goal;
  smaller.max_area = below(6);
  EXPECT_TRUE(reports_only(check(c, smaller, options), Kind::large_area));
  c.pslg.regions[0].max_area = below(6);
  EXPECT_TRUE(reports_only(check(c, goal, options), Kind::region_area));
  c.pslg.regions[0].max_area = 6;
  options.max_circumradius = below(2.5);
  EXPECT_TRUE(reports_only(check(c, goal, options), Kind::large_circumradius));
  for (const double none : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_TRUE(is_valid(check(c, goal, {.max_circumradius = none}))) << none;
  facts.cases = 8;
}

}  // namespace
}  // namespace pardel::checker
