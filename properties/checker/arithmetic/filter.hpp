// Filters: tests in floating-point arithmetic that answer `yes` only if the exact answer is certainly `yes`. They leave
// everything else to the exact functions of exact.hpp. Thread-safe; rounding must be to nearest.
//
// Bounds. Let u = 2^-53. For finite doubles fl(x - y) = (x - y)(1 + d) with |d| <= u, also if the result is subnormal.
// So a product of two differences has a relative error below 3.01 u, and the sum of two such products, which may
// cancel, an error below 4.01 u times the sum of their absolute values. For a cross or dot product of two sides p, q of
// a triangle this sum is at most |p| |q| <= (|p|^2 + |q|^2) / 2 <= S / 2, where S is the sum of the three squared
// lengths: the error is below 2.01 u S. Products that are subnormal add up to 2^-1073, which is far below u S if
// S >= 2^-300. The computed S has a relative error below 6.01 u, which the constants below allow for.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "../../../core/pslg.hpp"

namespace pardel::checker::filter {

inline constexpr double unit = 0x1p-53;
/// Sums of squared lengths between these bounds neither overflow nor lose digits in the formulas of this file.
inline constexpr double least_square = 0x1p-300, largest_square = 0x1p300;

/// What all tests of one triangle share. Rounded. Side k is opposite corner k.
struct Shape {
  Shape(Point a, Point b, Point c) {
    const Point s0{c.x - b.x, c.y - b.y}, s1{a.x - c.x, a.y - c.y}, s2{b.x - a.x, b.y - a.y};
    squared = {s0.x * s0.x + s0.y * s0.y, s1.x * s1.x + s1.y * s1.y, s2.x * s2.x + s2.y * s2.y};
    dot = {-(s1.x * s2.x + s1.y * s2.y), -(s2.x * s0.x + s2.y * s0.y), -(s0.x * s1.x + s0.y * s1.y)};
    doubled_area = s2.y * s1.x - s2.x * s1.y;
    sum = squared[0] + squared[1] + squared[2];
    error = 2.1 * unit * sum;
    longest = std::max({squared[0], squared[1], squared[2]});
    shortest = std::min({squared[0], squared[1], squared[2]});
    largest_dot = std::max({dot[0], dot[1], dot[2]});
    least_dot = std::min({dot[0], dot[1], dot[2]});
  }

  /// True if the triangle is certainly counter-clockwise, of moderate size, and not flat: the sine of each angle is
  /// above 2^-20. Then doubled_area has a relative error below 2^-30. Precondition of all tests below.
  [[nodiscard]] bool is_tame() const {
    return sum >= least_square && sum <= largest_square && doubled_area > 0x1p-20 * sum;
  }

  std::array<double, 3> squared;  ///< lengths of the sides
  std::array<double, 3> dot;      ///< of the two sides at each corner, seen from the corner
  double doubled_area;
  double sum;    ///< of squared
  double error;  ///< more than the errors of doubled_area and of each dot
  double longest, shortest, largest_dot, least_dot;
};

/// True if d certainly lies outside the circumcircle of the triangle. Side k of the triangle joins `from` and `to`; d
/// is the corner of the triangle on the other side of it.
///
/// Let g and h be the angles at the corner k and at d, seen from which the side is (from, to). d lies outside if
/// g + h < 180 degrees, that is if sin(g + h) > 0. Times the lengths of the four sides, this is
///     cross(g) dot(h) + dot(g) cross(h) > 0,
/// and the left side is minus the in-circle determinant, so the statement holds for every d. With T = |d from|^2 +
/// |d to|^2, cross(h) and dot(h) are at most T / 2 and have errors below 2.01 u T. So each product is at most S T / 4
/// and has an error below (4.02 + 4.02 + 1.01) u S T / 4 = 2.27 u S T, and the sum rounds by at most 0.51 u S T:
/// together less than 5.1 u S T.
[[nodiscard]] inline bool is_outside_circle(const Shape& shape, int k, Point from, Point to, Point d) {
  const Point p{from.x - d.x, from.y - d.y}, q{to.x - d.x, to.y - d.y};
  const double squares = (p.x * p.x + p.y * p.y) + (q.x * q.x + q.y * q.y);
  const double cross = q.x * p.y - q.y * p.x;
  const double dot = p.x * q.x + p.y * q.y;
  const double sine = shape.doubled_area * dot + shape.dot[static_cast<std::size_t>(k)] * cross;
  // Squares that are too small or too large, or not a number, answer `no`.
  if (!(squares >= least_square && squares <= largest_square)) return false;
  return sine > 5.5 * unit * shape.sum * squares;
}

/// The cotangent of an angle below which no angle may lie, rounded down. `cosine` is in [0, 1).
[[nodiscard]] inline double cotangent_below(double cosine) {
  // 1 - cosine is exact for cosine >= 1/2 and has a relative error of u otherwise; four more roundings follow, of which
  // the one before the square root counts half.
  return cosine / std::sqrt((1 - cosine) * (1 + cosine)) * (1 - 8 * unit);
}

/// True if no angle certainly is below the angle with this cotangent (from cotangent_below()).
[[nodiscard]] inline bool has_no_angle_below(const Shape& shape, double cotangent) {
  // The cosine of an angle is below the bound if dot < cotangent * doubled_area. Both sides have errors below `error`;
  // the products and sums round by less than 4 u of their values, which are below the sum of squares.
  return shape.largest_dot + 2 * shape.error < cotangent * (shape.doubled_area - 2 * shape.error) * (1 - 4 * unit);
}

/// True if the area certainly is at most `bound`.
[[nodiscard]] inline bool is_not_larger(const Shape& shape, double bound) {
  return shape.doubled_area + 2 * shape.error < 2 * bound;
}

/// True if no side certainly is longer than `bound` (not negative). A squared length has a relative error below 4.01 u.
[[nodiscard]] inline bool is_not_longer(const Shape& shape, double bound) {
  return shape.longest * (1 + 8 * unit) < bound * bound;
}

/// True if the circumradius certainly is at most `bound` (positive): |s0| |s1| |s2| <= 2 bound * doubled_area, squared.
[[nodiscard]] inline bool has_no_larger_circumradius(const Shape& shape, double bound) {
  const double limit = 2 * bound * (shape.doubled_area - 2 * shape.error);
  return shape.squared[0] * shape.squared[1] * shape.squared[2] * (1 + 32 * unit) < limit * limit;
}

}  // namespace pardel::checker::filter
