// Units by their definition (properties/THEORY.md, "Checker: what a certificate says"), in exact arithmetic. Nothing
// here comes from the checker, so that a mistake in its units is a difference.
#pragma once

#include <algorithm>
#include <cmath>

#include "../../ref/definitions.hpp"

namespace pardel::fuzz {

/// The distance from a number, not negative, to the next larger double. The doubles from 2^e to 2^(e+1) are the
/// multiples of 2^(e-52), and all doubles are multiples of 2^-1074. 0 for 0.
[[nodiscard]] inline ref::Number unit_at(double magnitude) {
  if (magnitude == 0) return 0;
  int above = 0;  // the number is at least 2^(above - 1), and less than 2^above
  std::frexp(magnitude, &above);
  return std::ldexp(1.0, std::max(above - 53, -1074));
}

/// The unit at the largest coordinate of three points.
[[nodiscard]] inline ref::Number unit_at(Point p, Point q, Point r) {
  return unit_at(std::max({std::abs(p.x), std::abs(p.y), std::abs(q.x), std::abs(q.y), std::abs(r.x), std::abs(r.y)}));
}

/// Twice the signed area of a, b, p.
[[nodiscard]] inline ref::Number cross(const ref::ExactPoint& a, const ref::ExactPoint& b, const ref::ExactPoint& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

/// Is p at most two units of the segment from a to b off its line? The unit of the segment is u = (ux |b.y - a.y| +
/// uy |b.x - a.x|) / |ab|, and the distance is |cross| / |ab|. Both are multiplied by |ab|.
[[nodiscard]] inline bool is_within_two_units(Point p, Point a, Point b) {
  using ref::exact;
  const ref::Number ux = unit_at(std::max(std::abs(a.x), std::abs(b.x)));
  const ref::Number uy = unit_at(std::max(std::abs(a.y), std::abs(b.y)));
  const ref::Number unit = ux * CGAL::abs(ref::Number(b.y) - a.y) + uy * CGAL::abs(ref::Number(b.x) - a.x);
  return CGAL::abs(cross(exact(a), exact(b), exact(p))) <= 2 * unit;
}

}  // namespace pardel::fuzz
