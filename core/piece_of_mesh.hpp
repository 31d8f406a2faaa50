// The piece of a mesh that one of several processes (ranks) has, as the writers of files need it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh.hpp"

namespace pardel {

/// The vertices that two pieces have in common.
struct SharedVertices {
  int rank = 0;  ///< the rank that has the other piece; the number of that piece, if ranks have several
  std::vector<Index>
      vertices;  ///< points of this piece, in the order of their numbers; the other piece has the same list
};

/// A view of a piece. Each triangle, and each constrained edge, is in the piece of one rank; a vertex is in all pieces
/// that have a triangle at it. The pieces agree on the meaning of Mesh::region, and all have Mesh::point_markers.
struct PieceOfMesh {
  const Mesh& mesh;
  std::span<const std::uint64_t> number;   ///< per point of the piece, its number in the whole mesh
  std::span<const SharedVertices> shared;  ///< in ascending order of ranks
  /// The numbers from this one to the next rank's first_point are those of points near the piece. Ascends from rank to
  /// rank. That of rank 0 is the number of the points of the input, which have the least numbers.
  std::uint64_t first_point = 0;
  std::uint64_t points = 0;  ///< of the whole mesh
};

}  // namespace pardel
