// The smallest upright box around points.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "../../../core/pslg.hpp"

namespace pardel::schemes {

struct Extent {
  Point low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  [[nodiscard]] double width() const { return high.x - low.x; }
  [[nodiscard]] double height() const { return high.y - low.y; }
  /// The side of a square that covers the box.
  [[nodiscard]] double side() const { return std::max(width(), height()); }
  void include(Point p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};
[[nodiscard]] inline Extent extent_of(const std::vector<Point>& points) {
  Extent extent;
  for (const Point p : points) extent.include(p);
  return extent;
}

}  // namespace pardel::schemes
