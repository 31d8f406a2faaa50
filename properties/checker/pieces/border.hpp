// The sides of triangles at the border of a piece, and the triangles of other pieces across them.
#pragma once

#include <cstdint>
#include <vector>

#include "piece.hpp"

namespace pardel::checker {

/// A triangle of another piece, across a side of a triangle of this piece.
struct Across {
  int rank = -1;              ///< the rank that has it; -1: there is no such triangle
  Index triangle = no_index;  ///< its number in the whole mesh
  Index place = no_index;     ///< its index in the piece of its rank
  std::uint64_t apex = 0;     ///< the number of its corner opposite the side
  Point at;                   ///< where this corner is
  [[nodiscard]] bool exists() const { return rank >= 0; }
};

struct BorderSide {
  BoundaryEdge edge;  ///< in indices of this piece
  Across across;
};

/// Finds the triangles across all sides without a neighbour in the piece, in the order of Adjacency::boundary(). The
/// two triangles at an edge have it in opposite directions. If an edge has more than one triangle on a side, one pair
/// of triangles is joined and the others remain without a neighbour, as in rebuild_neighbours(). Collective.
[[nodiscard]] std::vector<BorderSide> join_border(const Piece& piece);

}  // namespace pardel::checker
