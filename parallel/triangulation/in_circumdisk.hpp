// In whose circumdisk a point lies, one triangle at a time.
#pragma once

#include "../arithmetic/predicates.hpp"
#include "triangulation.hpp"

namespace pardel::engine {

/// Whether p lies in the open circumdisk of a triangle, exactly.
[[nodiscard]] inline bool in_disk(const Triangulation& t, const Slot& slot, Point p) {
  return incircle(t.points[slot.v[0]], t.points[slot.v[1]], t.points[slot.v[2]], p) > 0;
}

}  // namespace pardel::engine
