// What the first rank has decided for the whole mesh, in the indices of one piece.
#pragma once

#include <utility>
#include <vector>

#include "../model/number_set.hpp"
#include "judgement.hpp"
#include "piece.hpp"

namespace pardel::checker {

/// The special vertices of a piece, by their numbers in the whole mesh.
class SpecialVertices {
 public:
  SpecialVertices(const Piece& piece, const NumberSet& special);
  /// no_index if the piece has no special vertex with this number.
  [[nodiscard]] Index find(std::uint64_t number) const;

 private:
  std::vector<std::pair<std::uint64_t, Index>> by_number_;  ///< (number, vertex), sorted
};

/// The parts of the chains that are edges of the piece. `broken` is empty.
[[nodiscard]] Chains chains_in_piece(const Piece& piece, const Judgement& judgement, const SpecialVertices& special);

/// The vertices of the piece at input points, except for settled ones that are not in the skeleton.
[[nodiscard]] InputVertices input_vertices_in_piece(const Piece& piece, const Judgement& judgement,
                                                    const SpecialVertices& special);

}  // namespace pardel::checker
