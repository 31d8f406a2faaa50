// Puts patches into the mesh around them.
#pragma once

#include <span>

#include "../concurrency/threads.hpp"
#include "../triangulation/triangulation.hpp"
#include "border_edges.hpp"

namespace pardel::engine {

/// Appends the triangles of the patches and joins them to the triangles around them. The inner points of the patches
/// become the last vertices. All ids that exist stay as they are. `t`: the result of cut_out(), refined since then.
/// `border`, `edges`: as for cut_out(). The number of threads does not change the result.
///
/// Returns false if an edge of the border is missing in `t`, which is then useless. This does not happen, because the
/// refinement splits no such edge.
[[nodiscard]] bool lay_patches(Triangulation& t, std::span<const RegionPatch> patches, std::span<const VertexId> border,
                               std::span<const BorderEdge> edges, const Threads& threads);

}  // namespace pardel::engine
