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
bool on_one_shell(const Case& c, double min_angle_deg = 33) {
  const Certificate certificate = check_at(c, min_angle_deg);
  return std::ranges::any_of(certificate.justified, [](const Justified& j) { return j.triangle == 1; });
}

/// True if 5 and x, as distances from the apex of a shell with this largest coordinate, differ by no more than the
/// tolerance of shells.
bool differ_little(double x, double largest) {
  const Gmpq unit = Gmpq(std::nextafter(largest, infinity)) - Gmpq(largest);
  const Gmpq difference = x < 5 ? Gmpq(5) - Gmpq(x) : Gmpq(x) - Gmpq(5);
  return difference <= Gmpq(1e-9) * Gmpq(std::max(x, 5.0)) + 8 * unit;
}

/// The same case, moved.
Case moved(Case c, double by) {
  for (Point& p : c.pslg.points) p = {p.x + by, p.y + by};
  for (Point& p : c.mesh.points) p = {p.x + by, p.y + by};
  return c;
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
                          "distances differ by at most 1e-9 of the larger plus 8 units at the largest coordinate of "
                          "the apex and both. Farther ends of the segments do not count",
             .source = source,
             .families = "a wedge of 53.13 degrees at the origin with ends at 20 or 2^40 (the relative term decides), "
                         "and at 2^30 (the units decide); x above and below 5"}) {
  const auto expect = [&](double x, bool justified, double end_of_leg, double offset) {
    const Point far_q{3 * end_of_leg, 4 * end_of_leg};
    EXPECT_EQ(on_one_shell(moved(wedge({10, 0}, far_q, {x, 0}, {3, 4}), offset)), justified) << x;
    ++facts.cases;
  };
  for (const double end_of_leg : {5.0, 0x1p38})
    for (const double end : {4.0, 6.0}) {
      const double x = last_of(5, end, [&](double d) { return differ_little(d, std::max(d, 5.0)); });
      ASSERT_NE(x, 5);
      expect(x, true, end_of_leg, 0);
      expect(std::nextafter(x, end), false, end_of_leg, 0);
    }
  // Numbers near 2^30 are multiples of 2^-22. 8 units are 2^-19, more than 1e-9 of 5.
  expect(5, true, 5, 0x1p30);
  expect(5 + 0x1p-19, true, 5, 0x1p30);
  expect(5 - 0x1p-19, true, 5, 0x1p30);
  expect(5 + 0x1p-19 + 0x1p-22, false, 5, 0x1p30);
  expect(5 - 0x1p-19 - 0x1p-22, false, 5, 0x1p30);
}

PARDEL_FACT(
    Tolerance, of_angles_across_a_shell_ends_at_the_stated_tangent,
    {.statement = "vertices on one shell around an angle θ justify the angle at a third vertex if its tangent is "
                  "at least sin θ / (2 - cos θ), within a relative error of 1e-8 and 8 units in each coordinate",
     .source = source,
     .families = "a wedge of 53.13 degrees cut at distance 5, whose leg ends near the next shell, at 10"}) {
  // The cosine is 3/5 and the sine 4/5, so the tangent is 4/7. The end at distance x sees the edge from (5, 0) to (3,
  // 4) with the tangent 4 / (x - 3).
  const auto is_allowed = [](double x) {
    const Gmpq cross = Gmpq(4) * (Gmpq(x) - 5), error = Gmpq(8) * Gmpq(0x1p-50) * ((Gmpq(x) - 5) + (Gmpq(x) - 3) + 4);
    const Gmpq tangent = Gmpq((1 - across_tolerance) * (0.8 / (2 - 0.6)));
    return cross + error >= tangent * (Gmpq(x) - 5) * (Gmpq(x) - 3);
  };
  const double x = last_of(10, 11, is_allowed);
  ASSERT_GT(x, 10);
  EXPECT_LT(x, 10 + 1e-6);
  const auto justified = [&](double leg) {
    ++facts.cases;
    const Certificate certificate = check_at(wedge({leg, 0}, {15, 20}, {5, 0}, {3, 4}), 33);
    return std::ranges::any_of(certificate.justified, [](const Justified& j) { return j.triangle == 1; });
  };
  EXPECT_TRUE(justified(9.9));
  EXPECT_TRUE(justified(10));
  EXPECT_TRUE(justified(x - 1e-12));
  EXPECT_FALSE(justified(x + 1e-12));
  EXPECT_FALSE(justified(11));
}

PARDEL_FACT(
    Tolerance, of_the_angle_of_a_shell_ends_at_sixty_degrees,
    {.statement = "vertices of two segments at the same distance from their common end justify a small angle "
                  "if the segments meet at less than 60 degrees, and not if they meet at more, decided exactly",
     .source = source,
     .families = "wedges with the directions (1, 0) and (1, y) for neighbouring doubles y around the root of 3; "
                 "wedges of 61 to 89 degrees"}) {
  // Across a shell at 60 degrees, the end of a leg at distance 2 sees an angle of 30 degrees, the least that is
  // justified; so does the other corner, which needs no cause.
  const auto wedge_of = [](double x, double y) { return wedge({2 + 1e-9, 0}, {16 * x, 16 * y}, {1, 0}, {x, y}); };
  double y = std::sqrt(3.0);
  if (std::fma(y, y, -3.0) > 0) y = std::nextafter(y, 0);
  const double next = std::nextafter(y, 2);
  ASSERT_TRUE(std::fma(y, y, -3.0) < 0 && std::fma(next, next, -3.0) > 0);
  EXPECT_TRUE(on_one_shell(wedge_of(0.5, y / 2), 30));
  EXPECT_FALSE(on_one_shell(wedge_of(0.5, next / 2), 30));
  facts.cases = 2;
  for (int degrees = 61; degrees < 90; ++degrees, ++facts.cases) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    EXPECT_FALSE(on_one_shell(wedge_of(std::cos(angle), std::sin(angle)), 30)) << degrees;
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
/// The same, moved to the right by 4, so that coordinates around the segment are of the size of its unit.
Case square_beside_the_origin() {
  Case c = square_around_the_origin();
  const auto move = [](Point& p) { p.x += 4; };
  for (Point& p : c.pslg.points) move(p);
  for (Point& p : c.mesh.points) move(p);
  for (Region& region : c.pslg.regions) move(region.seed);
  return c;
}
/// The unit of x on the segment from (4, -2) to (4, 2).
constexpr double unit = 0x1p-50;

/// Adds a point far away, in no triangle, to the domain and the mesh.
void add_stray_point(Case& c) {
  // Input points come first. The vertices behind them get the next numbers.
  const auto n = static_cast<Index>(c.pslg.points.size());
  c.pslg.points.push_back({1e20, 1e20});
  c.pslg.point_markers.push_back(0);
  std::vector<Point> points(c.mesh.points.begin(), c.mesh.points.end());
  points.insert(points.begin() + n, {1e20, 1e20});
  std::vector<Index> origins(c.mesh.origin.begin(), c.mesh.origin.end());
  origins.insert(origins.begin() + n, input_vertex);
  std::vector<int> markers(c.mesh.point_markers.begin(), c.mesh.point_markers.end());
  markers.insert(markers.begin() + n, 0);
  c.mesh.points.clear();
  c.mesh.points.append(points);
  c.mesh.origin.clear();
  c.mesh.origin.append(origins);
  c.mesh.point_markers.clear();
  c.mesh.point_markers.append(markers);
  const auto renumber = [n](Index& v) { v += v >= n ? 1 : 0; };
  for (Triangle& t : c.mesh.triangles)
    for (Index& v : t.v) renumber(v);
  for (ConstrainedEdge& e : c.mesh.constrained_edges) {
    renumber(e.a);
    renumber(e.b);
  }
}

PARDEL_FACT(
    Tolerance, of_chains_ends_at_the_stated_distance,
    {.statement = "a vertex may lie two units of its segment off it, whatever the other coordinates of the input "
                  "are. Further off it is reported as chain_off_segment; beyond a millionth of the length of the "
                  "segment, the segment is reported as broken_segment if no edge is listed as constrained",
     .source = source,
     .families = "a vertex beside a segment of length 4, at the two distances and at the next doubles; without "
                 "and with a stray point at (1e20, 1e20)"}) {
  bool stray = false;
  const auto expect = [&](double distance, bool listed, std::uint64_t off, std::uint64_t broken) {
    for (const double side : {-1.0, 1.0}) {
      Case c = square_beside_the_origin();
      c.mesh.points[6].x = 4 + side * distance;
      if (stray) add_stray_point(c);
      if (!listed) c.mesh.constrained_edges.clear();
      const Certificate certificate = check_at(c, 0);
      EXPECT_EQ(count(certificate, Kind::chain_off_segment), off) << distance << ": " << to_text(certificate);
      EXPECT_EQ(count(certificate, Kind::broken_segment), broken) << distance << ": " << to_text(certificate);
      ++facts.cases;
    }
  };
  constexpr double beyond = 0x1p-49;  // the spacing of doubles above 4, and so also of the distances
  for (const bool with_stray : {false, true}) {
    stray = with_stray;
    for (const bool listed : {true, false}) {
      expect(2 * unit, listed, 0, 0);
      expect(3 * unit, listed, 1, 0);
      expect(0x1p-18 - beyond, listed, 1, 0);
    }
    expect(0x1p-17, true, 1, 0);
    expect(0x1p-17, false, 0, 1);
  }
}

PARDEL_FACT(
    Tolerance, of_chains_is_that_of_each_axis,
    {.statement = "where both ends of a segment have the coordinate 0 in an axis, a vertex must have it exactly",
     .source = source,
     .families = "a vertex beside a segment from (0, -2) to (0, 2)"}) {
  for (const double x : {0.0, 0x1p-140, 0x1p-52}) {
    Case c = square_around_the_origin();
    c.mesh.points[6].x = x;
    EXPECT_EQ(count(check_at(c, 0), Kind::chain_off_segment), x == 0 ? 0U : 1U) << x;
    ++facts.cases;
  }
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
            {.statement = "a triangle that contains the seed of a hole is reported unless it has an edge on a segment "
                          "from which the seed is two units of the segment away",
             .source = source,
             .families = "a seed beside an edge, at this distance and at the next double"}) {
  const auto reported = [&](double distance) {
    Case c = square_beside_the_origin();
    c.pslg.regions.clear();
    c.mesh.region.clear();
    c.mesh.region_attributes.clear();
    c.pslg.holes = {{4 - distance, 0.75}};
    ++facts.cases;
    const Certificate certificate = check_at(c, 0);
    return std::ranges::count_if(certificate.violations, [](const Violation& v) {
      return v.kind == Kind::covered_exterior && v.witness.text().find("contains the seed") != std::string::npos;
    });
  };
  EXPECT_EQ(reported(2 * unit), 0);
  EXPECT_EQ(reported(2.5 * unit), 1);
}

}  // namespace
}  // namespace pardel::checker
