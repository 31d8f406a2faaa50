// Puts patches into a triangulation.
#pragma once

#include <span>
#include <vector>

#include "../concurrency/threads.hpp"
#include "../triangulation/triangulation.hpp"
#include "find_patches.hpp"

namespace pardel::engine {

/// Replaces the triangles inside the borders of the patches by the triangles of the patches. The inner points of the
/// patches become the last vertices. The triangles that `t` has keep their ids or disappear, and all triangles after
/// them are triangles of the patches. `border`: the vertices on the borders, in the order of the patches and of
/// Patch::pieces(). The number of threads does not change the result.
///
/// Returns false if an edge of a border is missing in `t`, which is then useless. This does not happen if the patches
/// are those of find_patches() (THEORY.md, Fill).
[[nodiscard]] bool lay_patches(Triangulation& t, std::span<const RegionPatch> patches, std::span<const VertexId> border,
                               const Threads& threads);

}  // namespace pardel::engine
