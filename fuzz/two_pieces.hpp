// A mesh in two pieces, as two ranks have it, for the files of pieces.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "../core/piece_of_mesh.hpp"

namespace pardel::fuzz {

struct TwoPieces {
  std::array<Mesh, 2> mesh;
  std::array<std::vector<std::uint64_t>, 2> number;  ///< per point of a piece, its number in the whole mesh
  std::array<std::vector<SharedVertices>, 2> shared;
  std::uint64_t points = 0;  ///< of the whole mesh; all count as points of the input

  [[nodiscard]] PieceOfMesh piece(std::size_t rank) const {
    return {mesh[rank], number[rank], shared[rank], points, points};
  }
};

/// The first half of the triangles, and the others. A constrained edge is in the first piece that has both ends.
/// Nothing if the mesh cannot be divided in this way: it has less than two triangles, a triangle with equal corners, a
/// point that no triangle has, or a constrained edge whose ends are in no common piece.
[[nodiscard]] std::optional<TwoPieces> in_two_pieces(const Mesh& mesh);

}  // namespace pardel::fuzz
