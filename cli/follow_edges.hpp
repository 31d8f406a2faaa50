// The constrained edges of a mesh as a file lists them: some lines may pass through nodes that they do not name.
#pragma once

#include <cstddef>
#include <string>

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"

namespace pardel::cli {

/// What follow_edges() has replaced.
struct FollowedEdges {
  std::size_t lines = 0;  ///< constrained edges that were no edges of triangles
  std::size_t edges = 0;  ///< of triangles, instead of them
};

/// Replaces each constrained edge that is no edge of a triangle, but passes exactly through nodes along such edges, by
/// these edges with its marker. `domain`: the constrained edges are its segments. Then they may also lie in its holes
/// or outside (lines_in_holes.hpp), and stay there. Error: `invalid_input` with the numbers of the file if there is
/// another one; the mesh does not change then. Time O(n log n) for n triangles and constrained edges if few of them are
/// no edges of triangles.
[[nodiscard]] Result<FollowedEdges> follow_edges(Mesh& mesh, const Pslg* domain = nullptr);

/// Says how many edges were taken instead of lines; empty if there were no such lines.
[[nodiscard]] std::string note_about(const FollowedEdges& followed);

}  // namespace pardel::cli
