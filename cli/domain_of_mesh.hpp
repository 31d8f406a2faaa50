// Reconstructs the domain of a mesh that was read without a Pslg.
#pragma once

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"

namespace pardel::cli {

/// Gives the points of the mesh to a Pslg, with their attributes and markers, in the place of its own. Time O(n).
void take_points(Pslg& pslg, const Mesh& mesh);

/// Returns a Pslg with the points of the mesh, with its constrained edges and boundary edges as segments, with one
/// point in each hole, and with one region for each face whose triangles have an attribute. If triangles of the same
/// face have different attributes, there are no regions. Time O(n log n).
[[nodiscard]] Result<Pslg> domain_of(const Mesh& mesh);

/// Error: `invalid_input`, with the numbers of the file, if two nodes of the boundary are at one place, a node lies on
/// an edge of the boundary, or two such edges cross: triangles overlap, or should share an edge or a node and do not.
/// domain_of() refuses such a mesh, too. Time O(n log n).
[[nodiscard]] Status check_boundary(const Mesh& mesh);

}  // namespace pardel::cli
