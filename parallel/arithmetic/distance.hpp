// The distance of two points.
#pragma once

#include <cmath>

#include "../../core/pslg.hpp"

namespace pardel::engine {

/// The distance of two points. It is the same on all platforms, which std::hypot is not: libraries round it in
/// different ways. Precondition: the squares of the differences do not overflow.
[[nodiscard]] inline double distance(Point a, Point b) {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace pardel::engine
