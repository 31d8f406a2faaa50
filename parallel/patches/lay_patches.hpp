// Puts patches into the mesh around them.
#pragma once

#include <span>

#include "../../core/mesh.hpp"
#include "../concurrency/threads.hpp"
#include "border_edges.hpp"

namespace pardel::engine {

/// Appends the triangles of the patches and joins them to the triangles around them. The inner points of the patches
/// become the last points. All ids that exist stay as they are. The number of threads does not change the result.
///
/// `mesh`: the result of cut_out(), refined since then and converted. It has no markers and attributes of points yet.
/// Its points from `first_border` on are those on the borders, in the order of the patches and of Patch::pieces(). The
/// triangles beside a patch have no neighbour there.
///
/// The patches are laid into the finished mesh, not into the engine's triangulation, because nearly all triangles are
/// laid: to convert them would take as long as to write them.
///
/// Returns false if an edge of a border is missing in the mesh, which is then useless. This does not happen, because
/// the refinement splits no such edge.
[[nodiscard]] bool lay_patches(Mesh& mesh, std::span<const RegionPatch> patches, Index first_border,
                               const Threads& threads);

}  // namespace pardel::engine
