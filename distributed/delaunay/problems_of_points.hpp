// The problems of points that are divided among ranks. All functions are collective, and return the same on all ranks.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "../../core/part_of_points.hpp"
#include "../../core/ranks.hpp"
#include "../../parallel/threads/threads.hpp"
#include "../../parallel/validate.hpp"
#include "own_points.hpp"

namespace pardel::engine {

/// The id of a point in a Problem, which has 32 bits: no_index for a number that is too large.
[[nodiscard]] constexpr Index id_of_problem(std::uint64_t number) {
  return static_cast<Index>(std::min<std::uint64_t>(number, no_index));
}

/// wrong_count, if the numbers of attributes or markers do not fit the points of a rank or if ranks differ about them,
/// and coordinates that exact arithmetic cannot use. As find_problems() in one process, at most 10,000 for each rank.
[[nodiscard]] std::vector<Problem> unusable_values(const PartOfPoints& read, Ranks& ranks, const Threads& threads);

/// Equal points, and all_points_collinear. As find_problems() in one process, at most 10,000 for each rank.
/// Precondition: the coordinates are usable.
[[nodiscard]] std::vector<Problem> unusable_positions(const OwnPoints& own, Ranks& ranks, const Threads& threads);

/// As find_problems() of a PartOfPoints (distributed.hpp). Uses up the points.
[[nodiscard]] std::vector<Problem> problems_of_points(PartOfPoints&& points, Ranks& ranks, const Threads& threads);

/// Done, or the error that lists the problems.
[[nodiscard]] Status status_of(const std::vector<Problem>& problems, FirstId first_id);

}  // namespace pardel::engine
