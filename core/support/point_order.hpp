// The lexicographic order of points.
#pragma once

#include "../pslg.hpp"

namespace pardel {

/// Orders points by x, and points with equal x by y. Along every line this is the order of the points on it.
[[nodiscard]] inline bool lexicographically_less(const Point& a, const Point& b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

}  // namespace pardel
