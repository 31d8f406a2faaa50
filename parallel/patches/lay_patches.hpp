// Puts patches into the mesh around them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "../../core/mesh.hpp"
#include "../threads/threads.hpp"
#include "find_patches.hpp"

namespace pardel::engine {

/// An edge between a triangle of a patch and one around the patches, as the first one sees it.
struct Seam {
  Index laid;     ///< the triangle of the patch, as its number in the mesh
  unsigned side;  ///< its side
  Index around;   ///< the other triangle
};

/// Makes the triangles of the patches neighbours of the triangles around them, as if they had been appended already.
/// Returns the edges, at which the other triangles have to become neighbours, too. The points on the borders become
/// interior points. `around`, `first_border`, and when there is no result: as for lay_patches().
[[nodiscard]] std::optional<std::vector<Seam>> join_to_patches(Mesh& around, std::span<const RegionPatch> patches,
                                                               Index first_border, const Threads& threads);

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
