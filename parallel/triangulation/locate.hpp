// Point location by a walk over the triangulation.
#pragma once

#include <cstdint>

#include "../arithmetic/predicates.hpp"
#include "triangulation.hpp"

namespace pardel::engine {

/// The non-ghost triangle that contains p, or a ghost triangle whose hull edge p lies beyond, found by a
/// visibility walk that takes the sides in pseudo-random order, from the non-ghost triangle `start`. It ends in
/// any constrained Delaunay triangulation with ghosts (with probability one; Devillers, Pion and Teillaud 2002).
/// No triangle is read beyond a side whose apex, there, may not be seen: the walk then ends with no_index.
template <class MaySee>
[[nodiscard]] TriangleId locate(const Triangulation& t, Point p, TriangleId start, const MaySee& may_see) {
  EdgeRef entered;  // the side through which the walk came in
  TriangleId at = start;
  // A fixed order of the sides could walk in circles where segments block the Delaunay property.
  std::uint32_t random = 1;
  for (;;) {
    const Slot& slot = t.slots[at];
    if (slot.is_ghost()) return at;
    EdgeRef out;
    random = random * 1664525U + 1013904223U;
    unsigned side = (random >> 16U) % 3;
    for (int tried = 0; tried < 3; ++tried, side = next_corner[side]) {
      if (at == entered.triangle() && side == entered.side()) continue;
      if (orient2d(t.points[slot.from(side)], t.points[slot.to(side)], p) < 0) {
        out = slot.n[side];
        break;
      }
    }
    if (out.none()) return at;
    if (!may_see(t.slot(out).v[out.side()])) return no_index;
    entered = out;
    at = out.triangle();
  }
}

[[nodiscard]] inline TriangleId locate(const Triangulation& t, Point p, TriangleId start) {
  return locate(t, p, start, [](VertexId) { return true; });
}

}  // namespace pardel::engine
