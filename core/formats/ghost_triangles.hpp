// The triangles of other pieces around a piece of a mesh, and the ranks that share a vertex.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "../piece_of_mesh.hpp"
#include "../ranks.hpp"

namespace pardel::files {

/// For each point at the border of a piece, the other ranks whose pieces have it, in ascending order.
class RanksOfPoints {
 public:
  explicit RanksOfPoints(const PieceOfMesh& piece);
  /// Empty for points that are not at the border.
  [[nodiscard]] std::span<const int> operator[](Index point) const;
  /// The points at the border, in ascending order.
  [[nodiscard]] const std::vector<Index>& points() const { return points_; }

 private:
  Array<char> is_shared_;  ///< per point
  std::vector<Index> points_;
  std::vector<std::size_t> start_;  ///< those of points_[i] are ranks_[start_[i]] to ranks_[start_[i + 1] - 1]
  std::vector<int> ranks_;
};

/// A triangle of the piece of another rank, with a corner in this piece.
struct GhostTriangle {
  std::uint64_t triangle = 0;             ///< its number in the whole mesh, rank by rank
  std::array<std::uint64_t, 3> number{};  ///< of its corners
  std::array<Point, 3> corners{};
};

/// Collective. `first_triangle`: the number of the triangles of the ranks before this one. Returns for each rank the
/// ghost triangles that are in its piece.
[[nodiscard]] std::vector<std::vector<GhostTriangle>> ghost_triangles(const PieceOfMesh& piece,
                                                                      const RanksOfPoints& ranks_of_points,
                                                                      std::uint64_t first_triangle, Ranks& ranks);

}  // namespace pardel::files
