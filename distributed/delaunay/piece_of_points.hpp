// The piece of a triangulation of given points that belongs to one rank.
#pragma once

#include "../../core/ranks.hpp"
#include "../../parallel/threads/threads.hpp"
#include "../distributed.hpp"
#include "local_delaunay.hpp"
#include "own_points.hpp"

namespace pardel::engine {

/// A triangle belongs to the rank that owns its lexicographically least corner. Uses up the triangulation. Collective.
/// Precondition: all triangles with an own corner are those of the triangulation of all points (resolve_halo()).
[[nodiscard]] MeshPiece make_piece_of_points(LocalDelaunay& delaunay, const OwnPoints& own, Ranks& ranks,
                                             const Threads& threads);

}  // namespace pardel::engine
