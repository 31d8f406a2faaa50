// A mesh in pieces, as several ranks have it, and the files of its pieces.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "../core/formats.hpp"
#include "../core/piece_of_mesh.hpp"

namespace pardel::fuzz {

struct MeshInPieces {
  std::vector<Mesh> mesh;
  std::vector<std::vector<std::uint64_t>> number;  ///< per point of a piece, its number in the whole mesh
  std::vector<std::vector<SharedVertices>> shared;
  std::uint64_t points = 0;  ///< of the whole mesh; all count as points of the input

  [[nodiscard]] PieceOfMesh piece(std::size_t rank) const {
    return {mesh[rank], number[rank], shared[rank], points, points};
  }
};

/// Each piece has about the same number of triangles, in their order. A constrained edge is in the first piece that has
/// both ends. Nothing if the mesh cannot be divided in this way: it has fewer triangles than pieces, a triangle with
/// equal corners, a point that no triangle has, or a constrained edge whose ends are in no common piece.
[[nodiscard]] std::optional<MeshInPieces> in_pieces(const Mesh& mesh, std::size_t count);

/// Writes `file`, a .pvtu, and the pieces piece_0.vtu, piece_1.vtu, ... beside it.
[[nodiscard]] Status write_pvtu(const MeshInPieces& pieces, const std::filesystem::path& file);
/// Writes msh_of_piece(file, 1), msh_of_piece(file, 2), ..., as ranks do together.
[[nodiscard]] Status write_msh(const MeshInPieces& pieces, const std::filesystem::path& file, MshEncoding encoding);

}  // namespace pardel::fuzz
