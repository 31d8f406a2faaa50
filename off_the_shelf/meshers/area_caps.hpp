// The bounds on size of a subdomain as bounds on areas, for meshers that know no others.
#pragma once

#include <vector>

#include "../subdomain_mesher.hpp"

namespace pardel::engine {

/// The largest area of each triangle; infinity: no bound. A longest edge stands for the area of the equilateral
/// triangle. If a triangle is small enough but has too long an edge, its cap is less than its area, so that it is
/// split. All caps are a little stricter than the goal, so that rounding does not matter.
[[nodiscard]] std::vector<double> area_caps(const Subdomain& subdomain);

}  // namespace pardel::engine
