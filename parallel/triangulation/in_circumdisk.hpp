// The in-circle test for a triangle of a triangulation.
#pragma once

#include "../arithmetic/predicates.hpp"
#include "held.hpp"
#include "triangulation.hpp"

namespace pardel::engine {

/// True if p lies in the open circumdisk of the triangle. Exact. Throws NotHeld if the triangle or p is not held.
[[nodiscard]] inline bool in_circumdisk(const Triangulation& t, const Slot& slot, Point p) {
  require_held(t.points[slot.v[0]]);
  require_held(p);
  return incircle(t.points[slot.v[0]], t.points[slot.v[1]], t.points[slot.v[2]], p) > 0;
}

}  // namespace pardel::engine
