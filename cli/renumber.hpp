// Renumbering of the vertices of a mesh.
#pragma once

#include <span>

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"

namespace pardel::cli {

/// Removes the vertices that are not in a triangle, and the constrained edges at them. The other vertices keep their
/// order. O(n).
void remove_unused_vertices(Mesh& mesh);

/// For a mesh of the domain that repair() made of `original`, with Repaired::point_map. Numbers the vertices as in the
/// original: its points come first, in their order. Of points that repair() merged, the first one becomes the vertex;
/// the others become vertices without a triangle. O(n).
void restore_numbering(Mesh& mesh, const Pslg& original, std::span<const Index> point_map);

}  // namespace pardel::cli
