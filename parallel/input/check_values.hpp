// Problems of single values: coordinates, counts, indices, caps. No repair removes them.
#pragma once

#include "../../core/pslg.hpp"
#include "findings.hpp"

namespace pardel::engine {

/// Adds non_finite_coordinate, coordinate_out_of_range, wrong_count and index_out_of_range. O(n).
void check_values(const Pslg& pslg, int threads, Findings& found);

/// Adds bad_region_cap. Apart from check_values() because a bad cap does not keep faces from being examined.
void check_region_caps(const Pslg& pslg, Findings& found);

}  // namespace pardel::engine
