// Numbers without holes: what tasks did not use of theirs is filled from the end.
#pragma once

#include "../concurrency/index_allocator.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// Moves the last vertices and triangles into the holes that unused numbers left, and cuts the arrays to length,
/// giving back what is left of their memory.
/// Precondition: both ledgers are settled. Linear in the number of triangles.
void close_ranks(Triangulation& t, const IndexAllocator& vertices, const IndexAllocator& triangles, int threads);

}  // namespace pardel::engine
