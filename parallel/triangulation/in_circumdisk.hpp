// The in-circle test for a triangle of a triangulation.
#pragma once

#include "../arithmetic/predicates.hpp"
#include "triangulation.hpp"

namespace pardel::engine {

/// True if p lies in the open circumdisk of the triangle. Exact.
[[nodiscard]] inline bool in_circumdisk(const Triangulation& t, const Slot& slot, Point p) {
  return incircle(t.points[slot.v[0]], t.points[slot.v[1]], t.points[slot.v[2]], p) > 0;
}

}  // namespace pardel::engine
