// Distances, rounded. For comparisons with bounds that allow for rounding.
#pragma once

#include <algorithm>
#include <cmath>

#include "../core/pslg.hpp"

namespace pardel::fuzz {

[[nodiscard]] inline double distance(Point a, Point b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// From a point to the segment from a to b.
[[nodiscard]] inline double distance(Point p, Point a, Point b) {
  const double x = b.x - a.x, y = b.y - a.y, squared = x * x + y * y;
  if (squared == 0) return distance(p, a);
  const double at = std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / squared, 0.0, 1.0);
  return distance(p, {a.x + at * x, a.y + at * y});
}

/// The largest magnitude of a coordinate.
[[nodiscard]] inline double largest_magnitude(const Pslg& pslg) {
  double largest = 0;
  for (const Point p : pslg.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return largest;
}

/// The shortest edge that the mesher makes at a place (Options::min_edge).
[[nodiscard]] inline double resolution(Point p) { return 0x1p-42 * std::max(std::abs(p.x), std::abs(p.y)); }

}  // namespace pardel::fuzz
