// Estimated numbers of triangles, whose sums do not depend on the order of the terms.
#pragma once

#include <algorithm>

namespace pardel::engine {

/// An estimate is a multiple of 1/1024. Sums of such numbers are exact, as long as they are below 2^43.
inline constexpr double parts_of_estimate = 1024;

/// The nearest estimate; at most 2 * 10^12.
[[nodiscard]] inline double estimate(double triangles) {
  constexpr double most = 2e12;
  constexpr double to_integers = 0x1.8p52;  // doubles of this size are integers, so the sum is rounded to one
  return (std::min(triangles, most) * parts_of_estimate + to_integers - to_integers) / parts_of_estimate;
}

/// An estimate that is not larger, at least 0.
[[nodiscard]] inline double estimate_below(double triangles) {
  return estimate(std::max(0.0, triangles - 0.5 / parts_of_estimate));
}

}  // namespace pardel::engine
