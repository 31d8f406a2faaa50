// An order of points in which those that are near each other follow each other.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "../arithmetic/box.hpp"

namespace pardel::engine {

/// Calls visit(i) once for the index of each point, tile by tile of a grid over the bounds: what is read of a mesh for
/// one point is then in the cache for the next. Points may lie outside the bounds, and may be NaN. O(n).
template <class Visit>
void visit_by_tile(std::span<const Point> points, const Box& bounds, const Visit& visit) {
  constexpr std::size_t side = 128, too_few = 4096;
  if (points.size() < too_few) {
    for (std::size_t i = 0; i < points.size(); ++i) visit(i);
    return;
  }
  const double per_x = side / (bounds.max_x - bounds.min_x), per_y = side / (bounds.max_y - bounds.min_y);
  const auto place = [](double distance) {
    return !(distance > 0) ? std::size_t{0} : distance < side ? static_cast<std::size_t>(distance) : side - 1;
  };
  std::vector<std::uint16_t> tile(points.size());
  std::vector<std::uint32_t> next(side * side + 1), order(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p = points[i];
    tile[i] =
        static_cast<std::uint16_t>(place((p.y - bounds.min_y) * per_y) * side + place((p.x - bounds.min_x) * per_x));
    ++next[tile[i] + std::size_t{1}];
  }
  for (std::size_t t = 0; t < side * side; ++t) next[t + 1] += next[t];
  for (std::size_t i = 0; i < points.size(); ++i) order[next[tile[i]]++] = static_cast<std::uint32_t>(i);
  for (const std::uint32_t i : order) visit(i);
}

}  // namespace pardel::engine
