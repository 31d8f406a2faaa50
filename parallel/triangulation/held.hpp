// A triangulation of which a process holds only a part.
#pragma once

#include <cmath>

#include "triangulation.hpp"

namespace pardel::engine {

/// Beyond the triangles that a process holds lies one triangle that stands for all others. Its corners are one vertex
/// whose coordinates are not numbers. So no filter decides whether a point lies in its circumdisk, and the exact test
/// first calls require_held(), which throws this. Constrained edges are not crossed, so what lies beyond them is not
/// noticed in this way.
struct NotHeld {};

/// Throws NotHeld if p is the corner of the triangle beyond the part that the process holds.
inline void require_held(const Point& p) {
  if (std::isnan(p.x)) [[unlikely]]
    throw NotHeld{};
}

/// False for the triangle beyond the part that the process holds.
[[nodiscard]] inline bool is_held(const Triangulation& t, TriangleId id) {
  return !std::isnan(t.points[t.slots[id].v[0]].x);
}

}  // namespace pardel::engine
