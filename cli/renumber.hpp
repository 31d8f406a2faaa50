// Other numberings of the vertices of a mesh.
#pragma once

#include <span>

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"

namespace pardel::cli {

/// Removes the vertices that no triangle has; the others keep their order. Constrained edges at removed
/// vertices go, too. Linear.
void remove_unused_vertices(Mesh& mesh);

/// `mesh` is one of what repair() made of `original`, whose points went where `point_map` says. Gives the
/// original points their numbers back: they come first, in order; of points that were merged the first
/// is the vertex, and the others are vertices without a triangle. Linear.
void restore_numbering(Mesh& mesh, const Pslg& original, std::span<const Index> point_map);

}  // namespace pardel::cli
