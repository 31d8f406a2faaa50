// The triangulation between two sweeps, for whoever watches the refinement.
#pragma once

#include <functional>

#include "../concurrency/index_allocator.hpp"
#include "../options.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// Is given a snapshot after each sweep; an Error ends the refinement.
using Watcher = std::function<Status(Triangulation&& snapshot, const Sweep&)>;

/// A copy without holes in its numbers. Precondition: both ledgers are settled. Linear in the number of triangles.
[[nodiscard]] Triangulation snapshot(const Triangulation& t, const IndexAllocator& vertices,
                                     const IndexAllocator& triangles, int threads);

}  // namespace pardel::engine
