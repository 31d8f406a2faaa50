// Exact signs of the two geometric predicates. In nearly all cases a floating-point filter determines the sign. If it
// cannot, the determinant is evaluated exactly with floating-point expansions (Shewchuk, "Adaptive Precision
// Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997).
//
// The sign is exact for coordinates that are zero or satisfy smallest_coordinate <= |x| <= largest_coordinate.
// validate() checks this for the input, and snapped() ensures it for computed points. The code must be compiled without
// -ffast-math and with -ffp-contract=off.
#pragma once

#include <cmath>

#include "../../core/pslg.hpp"
#include "pair.hpp"

namespace pardel::engine {

inline constexpr double largest_coordinate = 0x1p200;
inline constexpr double smallest_coordinate = 0x1p-140;

/// True if the predicates are exact for this coordinate; false for NaN and infinity.
[[nodiscard]] inline bool is_usable(double x) {
  return x == 0 || (std::abs(x) >= smallest_coordinate && std::abs(x) <= largest_coordinate);
}
[[nodiscard]] inline bool is_usable(Point p) { return is_usable(p.x) && is_usable(p.y); }

namespace exact {
[[nodiscard]] double orient2d(Point a, Point b, Point c);
[[nodiscard]] double incircle(Point a, Point b, Point c, Point d);
/// (b - a) x (c - a), up to a few roundings of the result: twice the area of a counter-clockwise triangle. The
/// determinant of orient2d() has the same sign, but may be falsified by as much as its magnitude.
[[nodiscard]] double twice_area(Point a, Point b, Point c);
}  // namespace exact

/// The orientation determinant of a, b and the origin in floating point, with a bound on its error. T is double or
/// Pair; a Pair holds two independent determinants.
template <class T>
struct Orientation {
  T determinant, error;

  Orientation(T ax, T ay, T bx, T by) {
    const T left = ax * by, right = ay * bx;
    determinant = left - right;
    // 3 + 16 eps of Shewchuk's ccwerrboundA, on |left| + |right| whatever their signs.
    constexpr double bound = (3.0 + 16.0 * 0x1p-53) * 0x1p-53;
    error = bound * (magnitude(left) + magnitude(right));
  }
  /// True if the sign of the determinant is correct, for a Pair the signs of both.
  [[nodiscard]] bool is_certain() const { return all(magnitude(determinant) > error); }
};

/// Positive when a, b, c make a left turn (counter-clockwise), negative for a right turn, zero if and only
/// if exactly collinear. Swapping two arguments flips the sign. The magnitude approximates twice the area.
[[nodiscard]] inline double orient2d(Point a, Point b, Point c) {
  const Orientation<double> turn(a.x - c.x, a.y - c.y, b.x - c.x, b.y - c.y);
  if (turn.is_certain()) return turn.determinant;
  return exact::orient2d(a, b, c);
}

/// The in-circle determinant of v, u, w in floating point, with a bound on its error. The arguments are relative to the
/// fourth point. T is double or Pair; a Pair holds two independent determinants. The caller supplies u2 and v2, the
/// squared lengths of u and v, because it has computed them for the previous triangle.
///
/// With e = 2^-53, relative errors are at most e for coordinates and 4e for squares. The error of u2 vy - v2 uy is at
/// most 7e (u2 |vy| + v2 |uy|). The error of the determinant is at most 11e times the sum of w2 (|vx uy| + |vy ux|) and
/// the two analogous terms. By the Cauchy-Schwarz inequality |vx uy| + |vy ux| <= (u2 + v2) / 2, so this sum is at most
/// u2 v2 + w2 u2 + w2 v2. The twelfth e covers the rounding of that bound. Nothing underflows: relative coordinates are
/// zero or at least 2^-192, and products of four of them at least 2^-768.
template <class T>
struct InCircle {
  T determinant, error;
  T square;  ///< the squared length of w

  InCircle(T ux, T uy, T vx, T vy, T wx, T wy, T u2, T v2) : square(wx * wx + wy * wy) {
    determinant = square * (vx * uy - vy * ux) + (wx * (u2 * vy - v2 * uy) - wy * (u2 * vx - v2 * ux));
    constexpr double bound = 12 * 0x1p-53;
    error = bound * (u2 * v2 + square * (u2 + v2));
  }
  /// True if the sign of the determinant is correct, for a Pair the signs of both.
  [[nodiscard]] bool is_certain() const { return all(magnitude(determinant) > error); }
};

/// For counter-clockwise a, b, c: positive when d lies strictly inside their circumcircle, negative
/// outside, zero if and only if exactly cocircular. Swapping two of a, b, c flips the sign.
[[nodiscard]] inline double incircle(Point a, Point b, Point c, Point d) {
  const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y;
  const InCircle<double> in(bx, by, ax, ay, c.x - d.x, c.y - d.y, bx * bx + by * by, ax * ax + ay * ay);
  if (in.is_certain()) [[likely]]
    return in.determinant;
  return exact::incircle(a, b, c, d);
}

/// Replaces a computed coordinate below smallest_coordinate by zero. Such a value is the rounding noise of a
/// cancellation.
[[nodiscard]] inline double snapped(double x) { return std::abs(x) < smallest_coordinate ? 0.0 : x; }

}  // namespace pardel::engine
