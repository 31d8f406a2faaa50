// What the first rank has decided for the whole mesh, in the indices of one piece.
#pragma once

#include "border.hpp"
#include "judgement.hpp"
#include "skeleton.hpp"

namespace pardel::checker {

/// The parts of the chains that are edges of the piece. `broken` is empty.
[[nodiscard]] Chains chains_in_piece(const Piece& piece, const Judgement& judgement, const SpecialVertices& special);

/// The vertices of the piece at input points.
[[nodiscard]] InputVertices input_vertices_in_piece(const Piece& piece, const Judgement& judgement,
                                                    const SpecialVertices& special);

/// The face of the domain around each triangle of the piece, as paint_faces() finds it. Collective.
[[nodiscard]] std::vector<Index> faces_in_piece(const Piece& piece, const Domain& domain, const Chains& chains,
                                                std::span<const BorderSide> border);

}  // namespace pardel::checker
