// Each tolerance of tolerances.hpp ends where it says: the largest difference that it allows is accepted, and the next
// larger double is reported.
#include <CGAL/Gmpq.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "../../../properties/checker/check.hpp"
#include "../../../properties/domains/generators/random.hpp"
#include "../../../properties/theorems/framework/property.hpp"
#include "meshes.hpp"
#include "verdicts.hpp"

namespace pardel::checker {
namespace {

using CGAL::Gmpq;
using Kind = ViolationKind;
using testing::Case;
using testing::count;
using testing::is_valid;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr const char* source = "properties/checker/tolerances.hpp";

Certificate check_at(const Case& c, double min_angle_deg) {
  Goal goal;
  goal.min_angle_deg = min_angle_deg;
  return testing::check(c, goal);
}

/// A wedge with its apex at the origin and the ends `far`. The vertices p and q of its mesh lie on the two legs.
Case wedge(Point far_p, Point far_q, Point p, Point q) {
  Case c;
  c.pslg.points = {{0, 0}, far_p, far_q};
  c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 0, 0}};
  c.mesh = testing::mesh_of({{0, 0}, far_p, far_q, p, q}, {{0, 3, 4}, {3, 1, 4}, {1, 2, 4}});
  c.mesh.origin[3] = origin_on_segment(0);
  c.mesh.origin[4] = origin_on_segment(2);
  c.mesh.constrained_edges = {{0, 3, 0, 1}, {3, 1, 0, 1}, {1, 2, 1, 1}, {2, 4, 2, 1}, {4, 0, 2, 1}};
  return c;
}

/// True if the checker finds that p and q justify the triangle of p, q and the end of p's leg.
bool on_one_shell(const Case& c) {
  const Certificate certificate = check_at(c, 15);
  return std::ranges::any_of(certificate.justified, [](const Justified& j) { return j.triangle == 1; });
}

/// True if 5 and x, as distances from the apex of a domain with this largest coordinate, differ by no more than the
/// tolerance of shells.
bool differ_little(double x, double largest) {
  const Gmpq ulp = Gmpq(std::nextafter(largest, infinity)) - Gmpq(largest);
  const Gmpq difference = x < 5 ? Gmpq(5) - Gmpq(x) : Gmpq(x) - Gmpq(5);
  return difference <= Gmpq(1e-9) * Gmpq(std::max(x, 5.0)) + 8 * ulp;
}

/// The last double from `near` in the direction of `end` for which holds() is true, by bisection. It is true at `near`
/// and false at `end`.
template <class Holds>
double last_of(double near, double end, const Holds& holds) {
  while (std::nextafter(near, end) != end) {
    const double middle = near + (end - near) / 2;
    (holds(middle) ? near : end) = middle;
  }
  return near;
}

PARDEL_FACT(Tolerance, of_shells_ends_at_the_stated_difference_of_distances,
            {.statement = "two vertices at distances 5 and x from a small angle justify a triangle if and only if the "
                          "distances differ by at most 1e-9 of the larger plus 8 units in the last place of the "
                          "largest coordinate",
             .source = source,
             .families = "a wedge of 53.13 degrees whose largest coordinate is 20 (the relative term decides) or 2^40 "
                         "(the units in the last place decide); x above and below 5"}) {
  for (const double scale : {5.0, 0x1p38}) {
    const Point far_q{3 * scale, 4 * scale};
    const double largest = 4 * scale;
    for (const double end : {4.0, 6.0}) {
      const double x = last_of(5, end, [&](double d) { return differ_little(d, largest); });
      ASSERT_NE(x, 5);
      EXPECT_TRUE(on_one_shell(wedge({20, 0}, far_q, {x, 0}, {3, 4}))) << x;
      EXPECT_FALSE(on_one_shell(wedge({20, 0}, far_q, {std::nextafter(x, end), 0}, {3, 4}))) << x;
      facts.cases += 2;
    }
    EXPECT_TRUE(on_one_shell(wedge({20, 0}, far_q, {5, 0}, {3, 4})));
    ++facts.cases;
  }
}

PARDEL_FACT(
    Tolerance, of_the_angle_of_a_shell_ends_at_sixty_degrees,
    {.statement = "vertices of two segments at the same distance from their common end justify a small angle "
                  "if the segments meet at less than 60 degrees, and not if they meet at more, decided exactly",
     .source = source,
     .families = "wedges with the directions (1, 0) and (1, y) for neighbouring doubles y around the root of 3; "
                 "wedges of 61 to 89 degrees"}) {
  const auto wedge_of = [](double x, double y) { return wedge({8, 0}, {16 * x, 16 * y}, {1, 0}, {x, y}); };
  double y = std::sqrt(3.0);
  if (std::fma(y, y, -3.0) > 0) y = std::nextafter(y, 0);
  const double next = std::nextafter(y, 2);
  ASSERT_TRUE(std::fma(y, y, -3.0) < 0 && std::fma(next, next, -3.0) > 0);
  EXPECT_TRUE(on_one_shell(wedge_of(0.5, y / 2)));
  EXPECT_FALSE(on_one_shell(wedge_of(0.5, next / 2)));
  facts.cases = 2;
  for (int degrees = 61; degrees < 90; ++degrees, ++facts.cases) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    EXPECT_FALSE(on_one_shell(wedge_of(std::cos(angle), std::sin(angle)))) << degrees;
  }
}

/// The square [-2, 2]^2 in eight triangles. Its middle vertex, 6, lies on the segment from (0, -2) to (0, 2).
Case square_around_the_origin() {
  Case c = testing::square_in_eight();
  const auto move = [](Point& p) { p = {p.x - 2, p.y - 2}; };
  for (Point& p : c.pslg.points) move(p);
  for (Point& p : c.mesh.points) move(p);
  for (Region& region : c.pslg.regions) move(region.seed);
  return c;
}
/// One unit in the last place of its largest coordinate.
constexpr double unit = 0x1p-51;

PARDEL_FACT(Tolerance, of_chains_ends_at_the_stated_distance,
            {.statement = "a vertex may lie two units in the last place of the largest coordinate off its segment. "
                          "Further off it is reported as chain_off_segment; beyond a millionth of the length of the "
                          "segment, the segment is reported as broken_segment if no edge is listed as constrained",
             .source = source,
             .families = "a vertex beside a segment of length 4, at the two distances and at the next doubles"}) {
  const auto expect = [&](double distance, bool listed, std::uint64_t off, std::uint64_t broken) {
    for (const double side : {-1.0, 1.0}) {
      Case c = square_around_the_origin();
      c.mesh.points[6].x = side * distance;
      if (!listed) c.mesh.constrained_edges.clear();
      const Certificate certificate = check_at(c, 0);
      EXPECT_EQ(count(certificate, Kind::chain_off_segment), off) << distance << ": " << to_text(certificate);
      EXPECT_EQ(count(certificate, Kind::broken_segment), broken) << distance << ": " << to_text(certificate);
      ++facts.cases;
    }
  };
  const auto beyond = [](double x) { return std::nextafter(x, infinity); };
  for (const bool listed : {true, false}) {
    expect(2 * unit, listed, 0, 0);
    expect(beyond(2 * unit), listed, 1, 0);
    expect(1e-6 * 4, listed, 1, 0);
  }
  expect(beyond(1e-6 * 4), true, 1, 0);
  expect(beyond(1e-6 * 4), false, 0, 1);
}

/// The double nearest to x. (CGAL::to_double() rounds towards zero.)
double rounded(const Gmpq& x) {
  const double near = CGAL::to_double(x);
  const auto error = [&](double y) { return CGAL::abs(Gmpq(y) - x); };
  return std::min({near, std::nextafter(near, -infinity), std::nextafter(near, infinity)},
                  [&](double y, double z) { return error(y) < error(z); });
}

/// The square of the distance of p from the line through a and b.
Gmpq squared_distance(Point p, Point a, Point b) {
  const Gmpq ux = Gmpq(b.x) - Gmpq(a.x), uy = Gmpq(b.y) - Gmpq(a.y);
  const Gmpq cross = ux * (Gmpq(p.y) - Gmpq(a.y)) - uy * (Gmpq(p.x) - Gmpq(a.x));
  return cross * cross / (ux * ux + uy * uy);
}

PARDEL_FACT(Tolerance, of_chains_allows_for_every_vertex_that_is_rounded_once,
            {.statement = "a point of a segment whose coordinates are rounded once is at most 0.71 units in the last "
                          "place off, sometimes more than 0.6, and this is within the tolerance of the segment",
             .source = source,
             .families = "random slanted segments with coordinates from 8 to 16, random points on them"}) {
  constexpr double unit_below_16 = 0x1p-49;
  generators::Random random(1);
  const auto coordinate = [&] { return 12 + double(random.between(-1'000'000, 1'000'000)) / 999'983; };
  double furthest = 0;
  for (int round = 0; round < 2'000; ++round) {
    const Point a{coordinate() - 2, coordinate()}, b{coordinate() + 2, coordinate()};
    const Gmpq share(random.between(1, 999'999), 1'000'000);
    const auto at = [&](double from, double to) { return rounded(Gmpq(from) + share * (Gmpq(to) - Gmpq(from))); };
    const Point p{at(a.x, b.x), at(a.y, b.y)};
    furthest = std::max(furthest, std::sqrt(CGAL::to_double(squared_distance(p, a, b))) / unit_below_16);
    Case c;
    c.pslg.points = {a, {12, 8.5}, b, {12, 15.5}};
    c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}, {0, 2, 0}};
    std::vector<Point> points = c.pslg.points;
    points.push_back(p);
    c.mesh = testing::mesh_of(points, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
    const Certificate certificate = check_at(c, 0);
    EXPECT_EQ(count(certificate, Kind::chain_off_segment) + count(certificate, Kind::broken_segment), 0U)
        << to_text(certificate);
    ++facts.cases;
  }
  EXPECT_GT(furthest, 0.6);
  EXPECT_LT(furthest, 0.7072);
  facts.notes.push_back("the furthest vertex lies " + std::to_string(furthest) + " units in the last place off");
}

PARDEL_FACT(Tolerance, of_seeds_of_holes_ends_at_the_tolerance_of_chains,
            {.statement = "a triangle that contains the seed of a hole is reported unless the seed lies within two "
                          "units in the last place of the largest coordinate of an edge of the triangle",
             .source = source,
             .families = "a seed beside an edge, at this distance and at the next double"}) {
  const auto reported = [&](double distance) {
    Case c = square_around_the_origin();
    c.pslg.regions.clear();
    c.mesh.region.clear();
    c.mesh.region_attributes.clear();
    c.pslg.holes = {{-distance, 0.75}};
    ++facts.cases;
    const Certificate certificate = check_at(c, 0);
    return std::ranges::count_if(certificate.violations, [](const Violation& v) {
      return v.kind == Kind::covered_exterior && v.witness.find("contains the seed") != std::string::npos;
    });
  };
  EXPECT_EQ(reported(2 * unit), 0);
  EXPECT_EQ(reported(std::nextafter(2 * unit, infinity)), 1);
}

}  // namespace
}  // namespace pardel::checker
