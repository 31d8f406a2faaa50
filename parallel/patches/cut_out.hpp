// Cuts patches out of a triangulation.
#pragma once

#include <span>

#include "../threads/threads.hpp"
#include "../triangulation/triangulation.hpp"
#include "border_edges.hpp"

namespace pardel::engine {

/// Removes the triangles inside the borders of the patches. The vertices on the borders get the origin border_vertex,
/// and the edges between them and the patches become boundary edges (Triangulation::on_border_of_patch). `border`,
/// `edges`: BorderEdges of the same vertices. The number of threads does not change the result.
///
/// Returns false if an edge of the border is missing in `t`, which is then useless. This does not happen if the patches
/// are those of find_patches() (THEORY.md, Fill).
[[nodiscard]] bool cut_out(Triangulation& t, std::span<const VertexId> border, const BorderEdges& edges,
                           const Threads& threads);

}  // namespace pardel::engine
