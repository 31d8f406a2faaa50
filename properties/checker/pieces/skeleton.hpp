// The skeleton of a mesh in pieces: the triangles around all vertices that have to do with the input. The first rank
// judges on it whatever concerns the domain as a whole: chains, coverage, markers. The skeleton is small if the mesh is
// large compared with its input.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "../../../core/result.hpp"
#include "../model/number_set.hpp"
#include "border.hpp"

namespace pardel::checker {

/// The numbers of all vertices that have to do with the input: those that are special in one piece (part_to_keep()),
/// and the ends of sides that have no triangle across them in any piece. Collective; the same on all ranks.
[[nodiscard]] NumberSet special_numbers(const PiecesRead& read, const Border& border, Ranks& ranks);

/// The input points that are settled in a piece of any rank, on the first rank. Collective.
[[nodiscard]] NumberSet settled_inputs(const PiecesRead& read, std::size_t inputs, Ranks& ranks);

/// On the first rank. A special vertex has all its triangles here.
struct Skeleton {
  Mesh mesh;  ///< vertices in the order of their numbers, triangles in the order of theirs; no regions
  std::vector<std::uint64_t> vertices;  ///< the numbers of the vertices in the whole mesh
  std::vector<Index> triangles;         ///< the numbers of the triangles in the whole mesh
  std::vector<char> is_special;         ///< per vertex
};

/// Collective. Returns the skeleton on the first rank, and nothing on the others. Precondition:
/// check_data_of_vertices() has found nothing.
[[nodiscard]] std::optional<Skeleton> gather_skeleton(const PiecesRead& read, const NumberSet& special, Ranks& ranks);

}  // namespace pardel::checker
