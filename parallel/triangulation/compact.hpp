// Compaction of a triangulation. Afterwards every index below the number of vertices or triangles is in use.
#pragma once

#include "../threads/index_allocator.hpp"
#include "../threads/threads.hpp"
#include "triangulation.hpp"

namespace pardel::engine {

/// Moves the last vertices and triangles into the unused indices, shortens the arrays, and releases the memory that
/// they no longer need. Time: linear in the number of triangles.
void compact(Triangulation& t, const IndexMoves& vertices, const IndexMoves& triangles, const Threads& threads);

/// The same, but corners keep the indices that the vertices had before: the caller renumbers them when it visits all
/// triangles anyway.
void compact_but_corners(Triangulation& t, const IndexMoves& vertices, const IndexMoves& triangles,
                         const Threads& threads);

/// A copy of the triangulation, compacted. Precondition: both allocators are settled.
[[nodiscard]] Triangulation compacted_copy(const Triangulation& t, const IndexAllocator& vertices,
                                           const IndexAllocator& triangles, const Threads& threads);

}  // namespace pardel::engine
