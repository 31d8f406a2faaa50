// Vectors and determinants of lattice points. turn() is exact in 64 bits for coordinates up to 2^28 in magnitude. The
// coordinates of the seeds of holes and regions, in quarters of the lattice unit, can be that large.
#pragma once

#include <algorithm>

#include "../lattice_domain.hpp"

namespace pardel::generators {

[[nodiscard]] constexpr LatticePoint operator-(LatticePoint p, LatticePoint q) { return {p.x - q.x, p.y - q.y}; }
[[nodiscard]] constexpr LatticePoint operator+(LatticePoint p, LatticePoint q) { return {p.x + q.x, p.y + q.y}; }
[[nodiscard]] constexpr LatticePoint operator*(std::int64_t k, LatticePoint p) { return {k * p.x, k * p.y}; }
[[nodiscard]] constexpr std::int64_t dot(LatticePoint p, LatticePoint q) { return p.x * q.x + p.y * q.y; }
[[nodiscard]] constexpr std::int64_t cross(LatticePoint p, LatticePoint q) { return p.x * q.y - p.y * q.x; }

/// Twice the signed area of a, b, c: positive if they turn left, zero if they are collinear.
[[nodiscard]] constexpr std::int64_t turn(LatticePoint a, LatticePoint b, LatticePoint c) {
  return cross(b - a, c - a);
}
/// True if p lies on ab and is not an end.
[[nodiscard]] constexpr bool lies_inside(LatticePoint p, LatticePoint a, LatticePoint b) {
  return turn(a, b, p) == 0 && dot(a - p, b - p) < 0;
}
/// True if the segments ab and cd cross in a point that is interior to both.
[[nodiscard]] constexpr bool cross_each_other(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  const auto opposite = [](std::int64_t s, std::int64_t t) { return (s < 0 && t > 0) || (s > 0 && t < 0); };
  return opposite(turn(a, b, c), turn(a, b, d)) && opposite(turn(c, d, a), turn(c, d, b));
}

__extension__ using Wide = __int128;

/// Positive if d lies inside the circle through a, b, c, zero on it. Precondition: a, b, c are counter-clockwise.
[[nodiscard]] constexpr Wide in_circle(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  const LatticePoint u = a - d, v = b - d, w = c - d;
  return Wide{dot(u, u)} * cross(v, w) + Wide{dot(v, v)} * cross(w, u) + Wide{dot(w, w)} * cross(u, v);
}

/// The longer side of the bounding box. Precondition: at least one point. Linear time.
[[nodiscard]] inline std::int64_t width(const std::vector<LatticePoint>& points) {
  const auto [left, right] = std::ranges::minmax(points, {}, &LatticePoint::x);
  const auto [low, high] = std::ranges::minmax(points, {}, &LatticePoint::y);
  return std::max(right.x - left.x, high.y - low.y);
}

}  // namespace pardel::generators
