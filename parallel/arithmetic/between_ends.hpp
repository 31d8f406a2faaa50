// Points of a segment, and values there, between those at its ends.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "../../core/support/point_order.hpp"
#include "distance.hpp"

namespace pardel::engine {

/// The middle of a segment, rounded. The same for both directions.
[[nodiscard]] inline Point middle_of(Point a, Point b) { return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}; }

/// An end of a segment, with its values.
struct SegmentEnd {
  Point at;
  std::span<const double> values;
};

/// Writes the values at the point p of the segment from a to b. They are linear along the segment, never beyond those
/// of the ends, and the same for the segment from b to a. Precondition: a and b are different points.
inline void interpolate_between(SegmentEnd a, SegmentEnd b, Point p, std::span<double> to) {
  if (lexicographically_less(b.at, a.at)) std::swap(a, b);
  const double behind = distance(a.at, p), ahead = distance(p, b.at);
  const double part = behind / (behind + ahead);
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = std::lerp(a.values[i], b.values[i], part);
}

}  // namespace pardel::engine
