// The projection of a point onto a line.
#pragma once

#include "../../core/pslg.hpp"
#include "expansion.hpp"

namespace pardel::engine {

/// The orthogonal projection of p onto the line through a and b, rounded once. Without the projection, the rounding
/// errors of repeated splits would add up. Precondition: p lies on the line up to rounding. The leading products then
/// nearly cancel, and their difference is exact.
[[nodiscard]] inline Point projected(Point p, Point a, Point b) {
  using namespace exact;
  const Two dx = two_difference(b.x, a.x), dy = two_difference(b.y, a.y);
  const Two ex = two_difference(p.x, a.x), ey = two_difference(p.y, a.y);
  const Two left = two_product(ex.head, dy.head), right = two_product(ey.head, dx.head);
  const double rest = (ex.head * dy.tail + ex.tail * dy.head) - (ey.head * dx.tail + ey.tail * dx.head);
  const double cross = (left.head - right.head) + ((left.tail - right.tail) + rest);
  const double off = cross / (dx.head * dx.head + dy.head * dy.head);
  return {p.x - off * dy.head, p.y + off * dx.head};
}

}  // namespace pardel::engine
