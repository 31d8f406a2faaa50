// The numbers that the vertices of pieces have in the whole mesh.
#pragma once

#include <cstdint>
#include <span>

#include "../../../core/ranks.hpp"
#include "../../../core/result.hpp"
#include "../model/adjacency.hpp"

namespace pardel::checker {

/// Returns the number of points of the whole mesh, which is the largest number plus one. Collective; an error is the
/// same on all ranks. Each number must belong to one vertex, with the same coordinates in all pieces that have it, and
/// a vertex in the interior of one piece must be in no other piece.
///
/// Errors: invalid_input if a number is missing or belongs to different vertices; resources if there are more points
/// than an Index can number. Memory: one bit per point of the whole mesh.
[[nodiscard]] Result<std::uint64_t> check_numbers(std::span<const Point> points, std::span<const std::uint64_t> number,
                                                  const Adjacency& adjacency, Ranks& ranks);

}  // namespace pardel::checker
