// Piece: the piece of a mesh that one rank checks, and the ranks that check the others.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "../../../core/ranks.hpp"
#include "../stages/stages.hpp"

namespace pardel::checker {

struct Piece {
  const Subject& subject;                 ///< the piece, with the names of its vertices and triangles in the whole mesh
  std::span<const std::uint64_t> number;  ///< per vertex: its number in the whole mesh
  std::uint64_t points = 0;               ///< the number of points of the whole mesh
  const Adjacency& adjacency;             ///< neighbours within the piece
  Ranks& ranks;

  [[nodiscard]] const Mesh& mesh() const { return subject.mesh; }
};

/// The rank that compares what the pieces say about the vertex with this number.
struct Referees {
  Referees(std::uint64_t points, int ranks) : share_(points / static_cast<std::uint64_t>(ranks) + 1) {}
  [[nodiscard]] int of(std::uint64_t number) const { return static_cast<int>(number / share_); }
  [[nodiscard]] std::uint64_t first(int rank) const { return static_cast<std::uint64_t>(rank) * share_; }
  [[nodiscard]] std::uint64_t share() const { return share_; }

 private:
  std::uint64_t share_;
};

/// True for the vertices of a piece that other pieces may have, too: the ends of sides without a neighbour in the
/// piece, and vertices without a triangle.
[[nodiscard]] inline bool is_at_border(Index v, const Adjacency& adjacency) {
  return adjacency.on_boundary(v) || !adjacency.has_triangle(v);
}

}  // namespace pardel::checker
