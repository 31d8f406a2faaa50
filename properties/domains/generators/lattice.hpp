// Signs of determinants of lattice points: exact in 64 bits for coordinates up to 2^28, which is what quarters of
// the largest lattice coordinate are.
#pragma once

#include "lattice_domain.hpp"

namespace pardel::generators {

[[nodiscard]] constexpr LatticePoint operator-(LatticePoint p, LatticePoint q) { return {p.x - q.x, p.y - q.y}; }
[[nodiscard]] constexpr LatticePoint operator+(LatticePoint p, LatticePoint q) { return {p.x + q.x, p.y + q.y}; }
[[nodiscard]] constexpr LatticePoint operator*(std::int64_t k, LatticePoint p) { return {k * p.x, k * p.y}; }
[[nodiscard]] constexpr std::int64_t dot(LatticePoint p, LatticePoint q) { return p.x * q.x + p.y * q.y; }
[[nodiscard]] constexpr std::int64_t cross(LatticePoint p, LatticePoint q) { return p.x * q.y - p.y * q.x; }

/// Positive where a, b, c turn left, zero on a line.
[[nodiscard]] constexpr std::int64_t turn(LatticePoint a, LatticePoint b, LatticePoint c) {
  return cross(b - a, c - a);
}
/// p lies on ab and is no end of it.
[[nodiscard]] constexpr bool lies_inside(LatticePoint p, LatticePoint a, LatticePoint b) {
  return turn(a, b, p) == 0 && dot(a - p, b - p) < 0;
}
/// The segments ab and cd meet in one point that is interior to both.
[[nodiscard]] constexpr bool cross_each_other(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  const auto opposite = [](std::int64_t s, std::int64_t t) { return (s < 0 && t > 0) || (s > 0 && t < 0); };
  return opposite(turn(a, b, c), turn(a, b, d)) && opposite(turn(c, d, a), turn(c, d, b));
}

__extension__ using Wide = __int128;

/// Positive where d lies inside the circle through a, b, c, given in counter-clockwise order; zero on it.
[[nodiscard]] constexpr Wide in_circle(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d) {
  const LatticePoint u = a - d, v = b - d, w = c - d;
  return Wide{dot(u, u)} * cross(v, w) + Wide{dot(v, v)} * cross(w, u) + Wide{dot(w, w)} * cross(u, v);
}

/// The longer side of the bounding box.
[[nodiscard]] std::int64_t width(const std::vector<LatticePoint>& points);

}  // namespace pardel::generators
