// Difficult inputs for predicates, and the correct results in rational arithmetic.
#pragma once

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <limits>
#include <ostream>
#include <utility>

#include "../../../core/pslg.hpp"

namespace pardel::engine {

inline void showValue(const Point& p, std::ostream& out) {  // RapidCheck calls it
  out << std::hexfloat << "(" << p.x << ", " << p.y << ")" << std::defaultfloat;
}

}  // namespace pardel::engine

namespace pardel::testing {

using Rational = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Four = std::array<Point, 4>;

inline Rational::Point_2 rational(Point p) { return {CGAL::Gmpq(p.x), CGAL::Gmpq(p.y)}; }
inline int true_orientation(Point a, Point b, Point c) {
  return CGAL::orientation(rational(a), rational(b), rational(c));
}
/// The sign of the in-circle determinant, for a, b, c in any orientation.
inline int true_incircle(Point a, Point b, Point c, Point d) {
  return CGAL::side_of_oriented_circle(rational(a), rational(b), rational(c), rational(d));
}
inline int sign(double x) { return (x > 0) - (x < 0); }

/// A multiple of 2^-53 in [0, 1).
inline rc::Gen<double> fraction() {
  return rc::gen::map(rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 53),
                      [](std::int64_t k) { return std::ldexp(static_cast<double>(k), -53); });
}
/// Four points with independent coordinates.
inline rc::Gen<Four> four(const rc::Gen<double>& x, const rc::Gen<double>& y) {
  return rc::gen::container<Four>(rc::gen::map(rc::gen::pair(x, y), [](std::pair<double, double> p) {
    return Point{p.first, p.second};
  }));
}
inline rc::Gen<double> multiple_of(double unit, int most) {
  return rc::gen::map(rc::gen::inRange(-most, most + 1), [=](int k) { return k * unit; });
}

inline rc::Gen<Four> uniform() { return four(fraction(), fraction()); }
inline rc::Gen<Four> small_lattice() { return four(multiple_of(1, 8), multiple_of(1, 8)); }
inline rc::Gen<Four> large_lattice() { return four(multiple_of(0x1p-60, 1 << 30), multiple_of(0x1p-60, 1 << 30)); }
/// Rounded multiples of a tenth, which do not form a lattice in binary arithmetic.
inline rc::Gen<Four> tenths() { return four(multiple_of(0.1, 30), multiple_of(0.1, 30)); }
/// Coordinates of a national grid in metres, with a resolution of a millimetre.
inline rc::Gen<Four> far_offset() {
  const auto around = [](double centre) {
    return rc::gen::map(multiple_of(0.001, 5000), [=](double x) { return centre + x; });
  };
  return four(around(654321), around(4987654));
}
/// Coordinates of both signs over the whole range of exponents, and zero.
inline rc::Gen<Four> extreme_exponents() {
  const auto coordinate = rc::gen::apply([](int k, int exponent) { return std::ldexp(k, exponent); },
                                         rc::gen::inRange(-1000000, 1000001), rc::gen::inRange(-140, 180));
  return four(coordinate, coordinate);
}
/// Rounded points of a unit circle, whose centre may be far from the origin.
inline rc::Gen<Four> on_a_circle() {
  return rc::gen::apply(
      [](std::array<int, 4> angle, double offset) {
        Four points;
        for (std::size_t i = 0; i < 4; ++i) points[i] = {offset + std::cos(angle[i] * 0.01), std::sin(angle[i] * 0.01)};
        return points;
      },
      rc::gen::container<std::array<int, 4>>(rc::gen::inRange(0, 628)), rc::gen::element(0.0, 0.3, 1e5));
}
/// The corners of a rectangle. They are exactly cocircular for all coordinates.
inline rc::Gen<Four> rectangle() {
  return rc::gen::map(uniform(), [](Four f) {
    return Four{Point{f[0].x, f[0].y}, Point{f[1].x, f[0].y}, Point{f[1].x, f[1].y}, Point{f[0].x, f[1].y}};
  });
}
/// Integer multiples of one vector, which are exactly collinear.
inline rc::Gen<Four> on_a_line() {
  return rc::gen::apply(
      [](std::array<int, 4> k, int dx, int dy) {
        Four points;
        for (std::size_t i = 0; i < 4; ++i) points[i] = {1.0 * k[i] * dx, 1.0 * k[i] * dy};
        return points;
      },
      rc::gen::container<std::array<int, 4>>(rc::gen::inRange(-1000, 1001)), rc::gen::inRange(-1000000, 1000001),
      rc::gen::inRange(-1000000, 1000001));
}
/// Two points, and two rounded points of the line through them up to 32 times as far, moved by up to two doubles in x
/// and y. Differences of coordinates are not exact, and determinants are as large as their rounding errors. So one case
/// in eight shows a filter that is twelve times too confident, and one in twenty a filter that is four times.
inline rc::Gen<Four> nearly_on_a_line() {
  const auto beside = [](double x, int doubles) {
    for (int i = 0; i < std::abs(doubles); ++i) x = std::nextafter(x, doubles > 0 ? 1e300 : -1e300);
    return x;
  };
  return rc::gen::apply(
      [=](Four points, std::array<double, 2> along, std::array<int, 4> moved) {
        const Point a = points[0], b = points[1];
        for (std::size_t i = 0; i < 2; ++i)
          points[2 + i] = {beside(a.x + 32 * along[i] * (b.x - a.x), moved[2 * i]),
                           beside(a.y + 32 * along[i] * (b.y - a.y), moved[2 * i + 1])};
        return points;
      },
      uniform(), rc::gen::container<std::array<double, 2>>(fraction()),
      rc::gen::container<std::array<int, 4>>(rc::gen::inRange(-2, 3)));
}
/// Three points whose determinant is about 1 although its two products are about 2^104: (m, n) and (k, l) with
/// m l - n k = 1, and a point so near to the origin that the differences of coordinates are not exact. Any fourth
/// point.
inline rc::Gen<Four> barely_turning() {
  return rc::gen::apply(
      [](std::int64_t m, std::int64_t k, std::array<int, 2> third, bool right, Point fourth) {
        // Euclid's algorithm, which keeps x m + y k = rest.
        std::array<std::int64_t, 3> now{m, 1, 0}, next{k, 0, 1};  // rest, x, y
        while (next[0] != 0) {
          const std::int64_t quotient = now[0] / next[0];
          for (std::size_t i = 0; i < 3; ++i) now[i] -= quotient * next[i];
          std::swap(now, next);
        }
        const auto divisor = static_cast<double>(now[0]);
        const Point a{static_cast<double>(m) / divisor, -static_cast<double>(now[2])};
        const Point b{static_cast<double>(k) / divisor, static_cast<double>(now[1])};
        const Point c{std::ldexp(third[0], -60), std::ldexp(third[1], -60)};
        return right ? Four{b, a, c, fourth} : Four{a, b, c, fourth};
      },
      rc::gen::inRange<std::int64_t>(std::int64_t{1} << 51, std::int64_t{1} << 53),
      rc::gen::inRange<std::int64_t>(std::int64_t{1} << 51, std::int64_t{1} << 53),
      rc::gen::container<std::array<int, 2>>(rc::gen::inRange(1, 1000)), rc::gen::arbitrary<bool>(),
      rc::gen::map(rc::gen::pair(fraction(), fraction()), [](auto p) {
        return Point{p.first, p.second};
      }));
}
/// Three corners of a rectangle, and a point near the fourth corner, on the tangent of the circle through the corners.
/// It is so near that the differences of coordinates are not exact, and that only the squares of their errors decide.
inline rc::Gen<Four> beside_a_circle() {
  return rc::gen::apply(
      [](int width, int height, int exponent, bool other_side) {
        const double w = width, h = height;
        const double step = std::ldexp(other_side ? -1.0 : 1.0, -exponent);
        return Four{Point{w, 0}, Point{w, h}, Point{0, h}, Point{h * step, -w * step}};
      },
      rc::gen::inRange(1, 1 << 20), rc::gen::inRange(1, 1 << 20), rc::gen::inRange(60, 80), rc::gen::arbitrary<bool>());
}
/// The points of the generator, all multiplied by one power of two.
inline rc::Gen<Four> scaled(const rc::Gen<Four>& generator) {
  return rc::gen::apply(
      [](Four points, int exponent) {
        for (Point& p : points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
        return points;
      },
      generator, rc::gen::inRange(-60, 60));
}
/// The points of the generator with one x coordinate replaced by an adjacent double.
inline rc::Gen<Four> nudged(const rc::Gen<Four>& generator) {
  return rc::gen::apply(
      [](Four points, std::size_t which, bool up) {
        Point& p = points[which];
        if (p.x != 0) p.x = std::nextafter(p.x, up ? 1e300 : -1e300);
        return points;
      },
      generator, rc::gen::inRange<std::size_t>(0, 4), rc::gen::arbitrary<bool>());
}

inline constexpr const char* hard_families =
    "lattices, tenths, far offsets, extreme exponents, circles, rectangles, lines, some of them nudged by one "
    "rounding, points next to a line or a circle at all magnitudes, points on the tangent of a circle, and products of "
    "2^104 that differ by 1";
inline rc::Gen<Four> hard_points() {
  return rc::gen::oneOf(uniform(), small_lattice(), large_lattice(), tenths(), far_offset(), extreme_exponents(),
                        on_a_circle(), rectangle(), on_a_line(), nudged(rectangle()), nudged(on_a_line()),
                        nudged(small_lattice()), nudged(far_offset()), nearly_on_a_line(), scaled(nearly_on_a_line()),
                        scaled(nudged(on_a_circle())), barely_turning(), beside_a_circle());
}

}  // namespace pardel::testing
