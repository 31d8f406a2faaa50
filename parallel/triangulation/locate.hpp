// Point location by a walk through the triangulation.
#pragma once

#include <cstdint>

#include "../arithmetic/predicates.hpp"
#include "triangulation.hpp"

namespace pardel::engine {

/// Returns the non-ghost triangle that contains p or, if p lies outside the convex hull, a ghost triangle whose hull
/// edge separates p from the hull. The visibility walk starts at the non-ghost triangle `start` and tries the sides of
/// each triangle in pseudo-random order. It terminates with probability one in every constrained Delaunay triangulation
/// with ghosts (Devillers, Pion and Teillaud 2002).
[[nodiscard]] inline TriangleId locate(const Triangulation& t, Point p, TriangleId start) {
  EdgeRef entered;  // the side of `at` that the walk crossed last
  TriangleId at = start;
  // With a fixed order of the sides the walk could cycle near constrained edges that are not Delaunay.
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
    entered = out;
    at = out.triangle();
  }
}

}  // namespace pardel::engine
