// The checker's filters are compared with exact arithmetic, on triangles and bounds that are as near to the limit as
// doubles can be, and its measures with the formulas that define them.
#include "../../../properties/checker/arithmetic/filter.hpp"

#include <cmath>
#include <limits>

#include "../../../properties/checker/arithmetic/exact.hpp"
#include "../../../properties/checker/arithmetic/measure.hpp"
#include "../../../properties/checker/model/measures.hpp"
#include "../../../properties/checker/tolerances.hpp"
#include "../../../properties/domains/generators/random.hpp"
#include "../../../properties/theorems/framework/property.hpp"
#include "../../../properties/theorems/framework/shares.hpp"

namespace pardel::checker {
namespace {

using Triangle3 = std::array<Point, 3>;

/// A number in [-1, 1] with all its digits.
double fraction(generators::Random& random) {
  return static_cast<double>(static_cast<std::int64_t>(random.next())) * 0x1p-63;
}

double moved(double x, int ulps) {
  for (; ulps > 0; --ulps) x = std::nextafter(x, std::numeric_limits<double>::infinity());
  for (; ulps < 0; ++ulps) x = std::nextafter(x, -std::numeric_limits<double>::infinity());
  return x;
}

/// Any corners; some triangles are slivers, very small or very large, or far from the origin.
Triangle3 any_triangle(generators::Random& random) {
  const double scale = random.chance(8) ? std::ldexp(1.0, random.between(-520, 500)) : 1;
  const double flatness = random.chance(4) ? std::ldexp(1.0, random.between(-60, 0)) : 1;
  const Point origin = random.chance(2) ? Point{fraction(random) * 3, fraction(random) * 3} : Point{0, 0};
  Triangle3 p;
  for (Point& corner : p)
    corner = {scale * (origin.x + fraction(random)), scale * (origin.y + flatness * fraction(random))};
  return p;
}

double sine(const Triangle3& p) {
  return doubled_area(p[0], p[1], p[2]) / (distance(p[0], p[1]) * distance(p[0], p[2]));
}

/// A point near the circle through the corners, between the first and the second if k is 2.
Point near_circle(const Triangle3& p, generators::Random& random) {
  const double ax = p[1].x - p[0].x, ay = p[1].y - p[0].y, bx = p[2].x - p[0].x, by = p[2].y - p[0].y;
  const double d = 2 * (ax * by - ay * bx), a2 = ax * ax + ay * ay, b2 = bx * bx + by * by;
  const Point centre{p[0].x + (by * a2 - ay * b2) / d, p[0].y + (ax * b2 - bx * a2) / d};
  const double radius = distance(centre, p[0]), angle = 4 * fraction(random);
  const Point on{centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
  return {moved(on.x, random.between(-3, 3)), moved(on.y, random.between(-3, 3))};
}

PARDEL_PROPERTY(
    Filter, that_finds_a_point_outside_a_circle_is_right,
    {.statement = "if the filter answers that a triangle is counter-clockwise, or that a point lies outside "
                  "its circumcircle, exact arithmetic gives the same answer",
     .source = "properties/checker/arithmetic/filter.hpp",
     .families = "triangles of all shapes and magnitudes; points within a few units in the last place of "
                 "the circle"}) {
  generators::Random random(*rc::gen::arbitrary<std::uint32_t>());
  int certain = 0;
  constexpr int tries = 200;
  for (int i = 0; i < tries; ++i) {
    Triangle3 p = any_triangle(random);
    if (exactly::orientation(p[0], p[1], p[2]) < 0) std::swap(p[0], p[1]);
    const filter::Shape shape(p[0], p[1], p[2]);
    if (!shape.is_tame()) continue;
    RC_ASSERT(exactly::orientation(p[0], p[1], p[2]) > 0);
    RC_ASSERT(sine(p) > 0x1p-21);
    const int k = random.between(0, 2);
    const Point from = p[(k + 1) % 3], to = p[(k + 2) % 3];
    const Point d = random.chance(8) ? any_triangle(random)[0] : near_circle(p, random);
    if (!filter::is_outside_circle(shape, k, from, to, d)) continue;
    ++certain;
    RC_ASSERT(exactly::in_circle(p[0], p[1], p[2], d) < 0);
  }
  properties::classify(certain > tries / 50, "at least one answer of fifty is certain", 90);
}

PARDEL_PROPERTY(Filter, that_finds_a_bound_met_is_right,
                {.statement = "if the filter answers that a triangle meets a bound on angles, areas, edges or "
                              "circumradii, exact arithmetic gives the same answer",
                 .source = "properties/checker/arithmetic/filter.hpp",
                 .families = "triangles of all shapes and magnitudes; bounds within a few units in the last place of "
                             "the value of the triangle"}) {
  generators::Random random(*rc::gen::arbitrary<std::uint32_t>());
  int certain = 0;
  constexpr int tries = 200;
  for (int i = 0; i < tries; ++i) {
    Triangle3 p = any_triangle(random);
    if (exactly::orientation(p[0], p[1], p[2]) < 0) std::swap(p[0], p[1]);
    const filter::Shape shape(p[0], p[1], p[2]);
    if (!shape.is_tame()) continue;
    const int ulps = random.between(-4, 40);

    double largest_cosine = 0;
    for (int k = 0; k < 3; ++k) {
      const Point at = p[k], a = p[(k + 1) % 3], b = p[(k + 2) % 3];
      const double cosine = std::cos(angle_deg(at, a, b) * std::numbers::pi / 180);
      largest_cosine = std::max(largest_cosine, cosine);
    }
    const double bound = moved(largest_cosine, ulps);
    if (bound < 1 && filter::has_no_angle_below(shape, filter::cotangent_below(bound))) {
      ++certain;
      for (int k = 0; k < 3; ++k) RC_ASSERT(!exactly::cosine_exceeds(p[k], p[(k + 1) % 3], p[(k + 2) % 3], bound));
    }
    const double area = moved(shape.doubled_area / 2, ulps);
    if (filter::is_not_larger(shape, area)) {
      ++certain;
      RC_ASSERT(!exactly::area_exceeds(p[0], p[1], p[2], area));
    }
    const double edge = moved(std::sqrt(shape.longest), ulps);
    if (filter::is_not_longer(shape, edge)) {
      ++certain;
      for (int k = 0; k < 3; ++k) RC_ASSERT(!exactly::length_exceeds(p[k], p[(k + 1) % 3], edge));
    }
    const double radius =
        moved(distance(p[0], p[1]) * distance(p[1], p[2]) / (2 * shape.doubled_area) * distance(p[2], p[0]), ulps);
    if (filter::has_no_larger_circumradius(shape, radius)) {
      ++certain;
      RC_ASSERT(!exactly::circumradius_exceeds(p[0], p[1], p[2], radius));
    }
  }
  properties::classify(certain > tries, "one answer for each triangle is certain", 90);
}

/// The measures as their definitions say: all values of all triangles, by the formulas of arithmetic/measure.hpp.
Certificate measured_directly(const std::vector<Triangle3>& triangles) {
  Certificate result;
  result.angle_histogram.assign(Measures::bins, 0);
  const auto keep = [](Extreme& extreme, bool better, double value, std::size_t t, Point where) {
    if (extreme.triangle == no_index || better) extreme = {value, static_cast<Index>(t), where};
  };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const std::array<std::array<Point, 3>, 3> turns{{{a, b, c}, {b, c, a}, {c, a, b}}};
    std::array<double, 3> length;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& [at, p, q] = turns[k];
      const double angle = angle_deg(at, p, q);
      keep(result.min_angle_deg, angle < result.min_angle_deg.value, angle, t, at);
      keep(result.max_angle_deg, angle > result.max_angle_deg.value, angle, t, at);
      ++result.angle_histogram[std::min(static_cast<std::size_t>(angle / 10), Measures::bins - 1)];
      length[k] = distance(p, q);
      keep(result.min_edge, length[k] < result.min_edge.value, length[k], t, midpoint(p, q));
      keep(result.max_edge, length[k] > result.max_edge.value, length[k], t, midpoint(p, q));
    }
    const auto [shortest, longest] = std::ranges::minmax(length);
    if (longest <= shortest * (1 + 1e-6)) ++result.equilateral;
    const double area2 = doubled_area(a, b, c);
    const Point centroid{a.x / 3 + b.x / 3 + c.x / 3, a.y / 3 + b.y / 3 + c.y / 3};
    const double radius = length[0] / (2 * area2) * length[1] * length[2];
    const double ratio = radius / std::min({length[0], length[1], length[2]});
    keep(result.max_area, area2 / 2 > result.max_area.value, area2 / 2, t, centroid);
    keep(result.max_circumradius, radius > result.max_circumradius.value, radius, t, centroid);
    keep(result.max_radius_edge_ratio, ratio > result.max_radius_edge_ratio.value, ratio, t, centroid);
  }
  return result;
}

/// Shapes that a mesh repeats, with ties and with angles at the ends of bins, and shapes near to them.
Triangle3 repeated_triangle(generators::Random& random, int tens) {
  const double angle = 10.0 * tens * std::numbers::pi / 180;
  const double side = random.chance(2) ? 1 : 2, other = random.chance(2) ? 1 : 1 + 0x1p-40 * random.between(-3, 3);
  const int ulps = random.chance(2) ? 0 : random.between(-9, 9);
  return {{{0, 0}, {side, 0}, {other * moved(std::cos(angle), ulps), other * moved(std::sin(angle), ulps / 2)}}};
}

PARDEL_PROPERTY(
    Measures, are_those_of_the_formulas,
    {.statement = "the extremes, the histogram of angles and the number of equilateral triangles have the values, "
                  "triangles and places that the formulas give, in one range of triangles and in two",
     .source = "properties/checker/model/measures.hpp",
     .families = "counter-clockwise triangles of all shapes and magnitudes; triangles that tie, or differ by "
                 "a few units in the last place; angles at multiples of 10 degrees"}) {
  generators::Random random(*rc::gen::arbitrary<std::uint32_t>());
  std::vector<Triangle3> triangles;
  const bool wild = random.chance(2);
  const int least = random.between(1, 16), largest = random.chance(2) ? least : 16;
  for (int i = 0; i < 60; ++i) {
    Triangle3 p =
        wild && random.chance(2) ? any_triangle(random) : repeated_triangle(random, random.between(least, largest));
    if (exactly::orientation(p[0], p[1], p[2]) < 0) std::swap(p[0], p[1]);
    const double radius = distance(p[0], p[1]) / (2 * doubled_area(p[0], p[1], p[2])) * distance(p[1], p[2]);
    if (doubled_area(p[0], p[1], p[2]) > 0 && std::isfinite(radius * distance(p[2], p[0]))) triangles.push_back(p);
  }
  RC_PRE(!triangles.empty());
  const std::size_t cut = static_cast<std::size_t>(random.between(0, static_cast<int>(triangles.size())));
  Measures first, second;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& p = triangles[t];
    (t < cut ? first : second).add(static_cast<Index>(t), p, filter::Shape(p[0], p[1], p[2]));
  }
  first.append(second);
  Certificate found;
  first.report(found);
  const Certificate expected = measured_directly(triangles);
  RC_ASSERT(found.angle_histogram == expected.angle_histogram);
  RC_ASSERT(found.equilateral == expected.equilateral);
  for (const auto extreme :
       {&Certificate::min_angle_deg, &Certificate::max_angle_deg, &Certificate::max_area, &Certificate::max_edge,
        &Certificate::min_edge, &Certificate::max_circumradius, &Certificate::max_radius_edge_ratio}) {
    RC_ASSERT((found.*extreme).value == (expected.*extreme).value);
    RC_ASSERT((found.*extreme).triangle == (expected.*extreme).triangle);
    RC_ASSERT((found.*extreme).where == (expected.*extreme).where);
  }
}

}  // namespace
}  // namespace pardel::checker
