// The shortest edge that refinement makes.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "../../core/pslg.hpp"
#include "../arithmetic/predicates.hpp"

namespace pardel::engine {

/// The shortest edge for which double precision suffices: coordinates near 2^k are 2^(k-53) apart, and those near 0 are
/// smallest_coordinate apart. The direction of an edge 2^11 times as long has three correct digits.
[[nodiscard]] inline double least_min_edge(std::span<const Point> points) {
  double largest = 0;
  for (const Point p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return std::max(largest * 0x1p-42, smallest_coordinate * 0x1p11);
}

}  // namespace pardel::engine
