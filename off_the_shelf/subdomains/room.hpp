// How much room a new point needs.
#pragma once

#include "../../parallel/arithmetic/floor.hpp"

namespace pardel::engine {

/// The least distance of a new point from other points and from edges that stay. Above the floor of double precision,
/// so that the refiner that completes the mesh has room around it.
[[nodiscard]] inline double room_at(Point p) { return 8 * Floor(0).at(p); }

}  // namespace pardel::engine
