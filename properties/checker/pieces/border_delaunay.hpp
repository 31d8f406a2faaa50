// The Delaunay property of edges between two pieces.
#pragma once

#include <utility>

#include "border.hpp"
#include "judgement.hpp"

namespace pardel::checker {

/// The edges of chains, by the numbers of their ends in the whole mesh.
class EdgesOfChains {
 public:
  explicit EdgesOfChains(const Judgement& judgement);
  [[nodiscard]] bool contains(Index a, Index b) const;

 private:
  std::vector<std::pair<Index, Index>> ends_;  ///< the smaller number first; sorted
};

/// Checks that edges between two pieces are locally Delaunay, as check_delaunay() does within a piece. The piece whose
/// triangle has the smaller number checks an edge. Returns how many triangles had such tests that floating-point
/// filters left open, though the scan had left no test open for them. `first_triangle`: the number of the piece's first
/// triangle in the whole mesh.
std::uint64_t check_border_delaunay(const KeptPart& part, Index first_triangle, std::span<const Across> across,
                                    const EdgesOfChains& chains, const Goal& goal, Findings& found);

}  // namespace pardel::checker
