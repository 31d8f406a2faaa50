// Units: the spacing of doubles at a place. Tolerances are multiples of them (tolerances.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "../../../core/pslg.hpp"

namespace pardel::checker {

/// The distance from |x| to the next larger double; 0 at 0, which every mesher computes exactly.
[[nodiscard]] inline double unit_at(double x) {
  if (x == 0) return 0;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double magnitude = std::abs(x), next = std::nextafter(magnitude, infinity);
  return next < infinity ? next - magnitude : magnitude - std::nextafter(magnitude, 0);
}

/// The unit at the largest coordinate of these points.
template <class... Points>
[[nodiscard]] double unit_at(Point p, const Points&... others) {
  return unit_at(std::max({std::abs(p.x), std::abs(p.y), std::abs(others.x)..., std::abs(others.y)...}));
}

/// One unit for each axis.
struct Units {
  double x, y;
};

/// The units of a segment, from the coordinates of its own two ends.
[[nodiscard]] inline Units units_of_segment(Point a, Point b) {
  return {unit_at(std::max(std::abs(a.x), std::abs(b.x))), unit_at(std::max(std::abs(a.y), std::abs(b.y)))};
}

}  // namespace pardel::checker
