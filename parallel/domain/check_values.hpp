// Problems of single values: coordinates, counts, indices, area caps. repair() cannot remove these problems.
#pragma once

#include "../../core/pslg.hpp"
#include "findings.hpp"

namespace pardel::engine {

/// The problem of a point whose coordinates are not usable (is_usable()).
[[nodiscard]] ProblemKind problem_of_coordinates(Point p);

/// Adds non_finite_coordinate, coordinate_out_of_range, wrong_count and index_out_of_range. O(n).
void check_values(const Pslg& pslg, const Threads& threads, Findings& found);

/// Adds bad_region_cap. Separate from check_values(), because faces can be examined in spite of a bad cap.
void check_region_caps(const Pslg& pslg, Findings& found);

}  // namespace pardel::engine
