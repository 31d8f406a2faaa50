// The area of a triangle in doubles, for messages and statistics.
#pragma once

#include "../pslg.hpp"

namespace pardel {

/// Twice the signed area of a, b, c. That of a thin triangle is measured from the corner opposite the longest side:
/// from a far corner, the difference of two near corners would be lost in rounding.
[[nodiscard]] inline double doubled_area(Point a, Point b, Point c) {
  const auto squared = [](Point p, Point q) { return (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y); };
  const auto from = [](Point o, Point p, Point q) { return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x); };
  constexpr double thin = 0x1p-12;
  const double ab = squared(a, b), bc = squared(b, c), ca = squared(c, a), area = from(a, b, c);
  if (area > thin * (ab + ca)) return area;
  if (bc >= ab && bc >= ca) return from(a, b, c);
  return ca >= ab ? from(b, c, a) : from(c, a, b);
}

}  // namespace pardel
