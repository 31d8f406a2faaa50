// The boundary of a mesh, and the faces around it that it does not cover.
#pragma once

#include <vector>

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"

namespace pardel::cli {

/// The edges that belong to exactly one triangle. Each is directed so that this triangle lies to its left.
[[nodiscard]] std::vector<Segment> boundary(const Mesh& mesh);

/// A Pslg of the edges and their ends, which it numbers anew. The segments are in the order of the edges.
[[nodiscard]] Pslg part_of(const Mesh& mesh, const std::vector<Segment>& edges);

/// The convex hull of a Pslg, and its faces between the first segments, which are the boundary of a mesh.
struct AroundMesh {
  Mesh hull;                  ///< a triangulation with the points of the Pslg
  std::vector<Index> face;    ///< per triangle of the hull
  std::vector<Index> best;    ///< per face: its largest triangle
  std::vector<char> is_out;   ///< per face: 1 if it reaches the boundary of the hull where no wall is
  std::vector<char> is_bare;  ///< per face: 1 if it lies to the right of a wall, where the mesh has no triangle
};
/// The first `walls` segments of `pslg` are the boundary, directed as boundary() directs it. Error: `invalid_input` if
/// the Pslg is no valid domain. Time O(n log n).
[[nodiscard]] Result<AroundMesh> around_mesh(const Pslg& pslg, std::size_t walls);

}  // namespace pardel::cli
