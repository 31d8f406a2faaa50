// The skeleton of a mesh in pieces: the triangles around all vertices that have to do with the input. The first rank
// judges on it whatever concerns the domain as a whole: chains, coverage, markers. The skeleton is small if the mesh is
// large compared with its input.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "../../../core/result.hpp"
#include "border.hpp"
#include "piece.hpp"

namespace pardel::checker {

/// The vertices of a piece that have to do with the input: its points, the ends of constrained edges and of boundary
/// edges, vertices with a marker or an origin, and vertices without triangles.
class SpecialVertices {
 public:
  /// Collective: a vertex is special in all pieces if it is special in one of them.
  SpecialVertices(const Piece& piece, std::span<const BorderSide> border);

  [[nodiscard]] bool contains(Index v) const { return is_special_[v] != 0; }
  /// The vertex of the piece with this number; no_index if the piece has no such special vertex.
  [[nodiscard]] Index find(std::uint64_t number) const;

 private:
  Array<char> is_special_;
  std::vector<std::pair<std::uint64_t, Index>> by_number_;  ///< (number, vertex), sorted
};

/// On the first rank. A special vertex has all its triangles here.
struct Skeleton {
  Mesh mesh;  ///< vertices in the order of their numbers, triangles in the order of theirs; no regions
  std::vector<std::uint64_t> vertices;  ///< the numbers of the vertices in the whole mesh
  std::vector<Index> triangles;         ///< the numbers of the triangles in the whole mesh
  std::vector<char> is_special;         ///< per vertex
};

/// Collective. Returns the skeleton on the first rank, and nothing on the others. Error, on all ranks: invalid_input if
/// pieces do not agree on the marker, the origin or the attributes of a special vertex.
[[nodiscard]] Result<std::optional<Skeleton>> gather_skeleton(const Piece& piece, const SpecialVertices& special);

}  // namespace pardel::checker
