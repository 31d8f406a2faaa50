// The sides of triangles at the borders of pieces, and the triangles of other pieces across them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kept_piece.hpp"

namespace pardel::checker {

/// A triangle of another piece, across a side of a triangle of a piece.
struct Across {
  int rank = -1;              ///< the rank that has it; -1: there is no such triangle
  Index side = no_index;      ///< its side there, among the sides of all pieces of its rank
  Index triangle = no_index;  ///< its number in the whole mesh
  Index apex = no_index;      ///< the number of its corner opposite the side
  Point at;                   ///< where this corner is
  [[nodiscard]] bool exists() const { return rank >= 0; }
};

/// The pieces that one rank has read, and the numbers in the whole mesh of their first triangles and listed edges.
struct PiecesRead {
  std::vector<KeptPiece> pieces;
  std::vector<Index> first_triangle, first_listed_edge;
  NumberSet settled;  ///< the numbers of input points that are settled in one of the pieces (part_to_keep())
};

/// What is across the sides of all pieces of a rank.
class Border {
 public:
  /// Finds the triangles across all sides. The two triangles at an edge have it in opposite directions. If an edge has
  /// more than one triangle on a side, one pair of triangles is joined and the others remain without a neighbour, as in
  /// rebuild_neighbours(). `points`: the number of points of the whole mesh. Collective.
  Border(const PiecesRead& read, std::uint64_t points, Ranks& ranks);

  /// In the order of KeptPart::sides.
  [[nodiscard]] std::span<const Across> of(std::size_t piece) const {
    return std::span(across_).subspan(first_[piece], first_[piece + 1] - first_[piece]);
  }
  /// The number of the first side of a piece among the sides of the rank.
  [[nodiscard]] std::size_t first(std::size_t piece) const { return first_[piece]; }

 private:
  std::vector<std::size_t> first_;  ///< per piece, and their number
  std::vector<Across> across_;
};

}  // namespace pardel::checker
