// The distance from a segment.
#pragma once

#include <algorithm>
#include <cmath>

#include "../../../core/pslg.hpp"

namespace pardel::engine {

/// The distance of p from the segment ab. a may be equal to b.
inline double distance_to(Point a, Point b, Point p) {
  const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  const double t = squared > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

}  // namespace pardel::engine
