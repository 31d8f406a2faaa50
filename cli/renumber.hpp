// Renumbering of the vertices of a mesh.
#pragma once

#include <span>
#include <vector>

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"

namespace pardel::cli {

/// Removes the vertices that are not in a triangle, and the constrained edges at them. The other vertices keep their
/// order. Returns the new index of each vertex, no_index for those removed. O(n).
std::vector<Index> remove_unused_vertices(Mesh& mesh);

/// Numbers the vertices of a mesh as in the domain `original`. The mesh was made from the domain that repair() made of
/// `original`; `point_map` is Repaired::point_map. The points of `original` come first, in their order. If repair()
/// merged several points, the first one becomes the vertex; the others become vertices without a triangle. Returns the
/// new index of each vertex. Time O(n).
std::vector<Index> restore_numbering(Mesh& mesh, const Pslg& original, std::span<const Index> point_map);

}  // namespace pardel::cli
