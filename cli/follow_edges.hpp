// The constrained edges of a mesh as a file lists them: some lines may pass through nodes that they do not name.
#pragma once

#include <cstddef>

#include "../core/mesh.hpp"
#include "../core/result.hpp"

namespace pardel::cli {

/// What follow_edges() has replaced.
struct FollowedEdges {
  std::size_t lines = 0;  ///< constrained edges that were no edges of triangles
  std::size_t edges = 0;  ///< of triangles, instead of them
};

/// Replaces each constrained edge that is no edge of a triangle, but passes exactly through nodes along such edges, by
/// these edges with its marker. Error: `invalid_input` with the numbers of the file if there is another one; the mesh
/// does not change then. Time O(n log n) for n triangles and constrained edges if few of them are replaced.
[[nodiscard]] Result<FollowedEdges> follow_edges(Mesh& mesh);

}  // namespace pardel::cli
