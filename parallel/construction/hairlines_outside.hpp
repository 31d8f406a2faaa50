// The hairlines outside a mesh.
#pragma once

#include <vector>

#include "../threads/threads.hpp"
#include "../triangulation/triangulation.hpp"
#include "hairlines.hpp"

namespace pardel::engine {

/// The hairlines between boundary edges of the triangulation of a domain, which has no ghosts. Positions are vertices.
/// None if vertices on the boundary have equal coordinates, or if boundary edges cross. O(b log b) for b boundary edges
/// and O(n) for n triangles.
[[nodiscard]] std::vector<Hairline> hairlines_outside(const Triangulation& t, const Threads& threads);

}  // namespace pardel::engine
