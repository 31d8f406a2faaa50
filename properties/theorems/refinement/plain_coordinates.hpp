// The coordinates that the executable specification takes (ref/constrained.hpp).
#pragma once

#include <algorithm>
#include <cmath>

#include "../../../core/pslg.hpp"

namespace pardel::properties {

/// The coordinates that ref/constrained.hpp takes: multiples of 2^-50 of absolute value at most 2^50. The box around
/// the domain (triangulation_by_definition()) must be in this range too.
[[nodiscard]] inline bool has_plain_coordinates(const Pslg& pslg) {
  return std::ranges::all_of(pslg.points, [](Point p) {
    const auto is_plain = [](double x) {
      return std::abs(x) <= 0x1p47 && std::ldexp(x, 50) == std::floor(std::ldexp(x, 50));
    };
    return is_plain(p.x) && is_plain(p.y);
  });
}

/// Multiplied by a power of two, so that the largest coordinate is just below 2^47. Small coordinates then need not be
/// plain. Caps on areas are not used.
[[nodiscard]] inline Pslg as_large_as_plain_coordinates(Pslg pslg) {
  double largest = 0;
  for (const Point p : pslg.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  const int power = 46 - std::ilogb(largest);
  const auto scale = [&](Point& p) { p = {std::ldexp(p.x, power), std::ldexp(p.y, power)}; };
  for (Point& p : pslg.points) scale(p);
  for (Point& p : pslg.holes) scale(p);
  for (Region& region : pslg.regions) scale(region.seed);
  return pslg;
}

}  // namespace pardel::properties
