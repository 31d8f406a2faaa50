// The bounds of T3 and T3-sharp on the circumradius r of a triangle, from a bound ρ̄ on the ratio of circumradius to
// shortest edge and a bound Δ̄ on the area.
//
// All quantities are squared until no root is left. So numbers are rational and equality is exact: with s = ρ̄², T3
// reads r⁴ ≤ 16 s³ Δ̄², and T3-sharp reads r⁴ ≤ 16 s⁴ Δ̄² / (4s - 1).
#pragma once

#include <algorithm>

#include "../../../ref/definitions.hpp"

namespace pardel::properties {

/// The squared measures of a triangle: r², l² of its shortest edge, A².
struct Squares {
  ref::Number radius, shortest, area;
  [[nodiscard]] ref::Number ratio() const { return radius / shortest; }
};

inline Squares squares_of(const ref::PlainMesh& mesh, const ref::Corners& t) {
  const ref::Number area = ref::area(mesh, t);
  return {ref::squared_circumradius(mesh, t), ref::squared_shortest_edge(mesh, t), area * area};
}

/// The largest r² and A² over the triangles of a mesh; `shortest` is chosen such that ratio() is the largest ρ².
inline Squares largest(const ref::PlainMesh& mesh) {
  Squares most{0, 1, 0};
  ref::Number ratio = 0;
  for (const ref::Corners& t : mesh.triangles) {
    const Squares squares = squares_of(mesh, t);
    ratio = std::max(ratio, squares.ratio());
    most.radius = std::max(most.radius, squares.radius);
    most.area = std::max(most.area, squares.area);
  }
  most.shortest = most.radius / ratio;
  return most;
}

/// The fourth powers of two bounds on r; `ratio` is ρ̄², `area` is Δ̄².
inline ref::Number paper_bound(const ref::Number& ratio, const ref::Number& area) {
  return 16 * ratio * ratio * ratio * area;
}
inline ref::Number sharp_bound(const ref::Number& ratio, const ref::Number& area) {
  return 16 * ratio * ratio * ratio * ratio * area / (4 * ratio - 1);
}
inline ref::Number fourth_power(const ref::Number& squared) { return squared * squared; }

}  // namespace pardel::properties
