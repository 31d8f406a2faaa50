// The given points that a rank owns.
#pragma once

#include <cstdint>
#include <vector>

#include "../../core/array.hpp"
#include "../../core/ranks.hpp"
#include "../concurrency/threads.hpp"
#include "../distributed.hpp"
#include "curve_division.hpp"

namespace pardel::engine {

/// Points in the order of the curve. Those of all ranks follow one another, so a point has a position among all points.
struct OwnPoints {
  Array<Point> at;
  Array<std::uint64_t> number;  ///< in the input
  Array<int> marker;            ///< empty if points have no markers
  std::size_t attributes_per_point = 0;
  Array<double> attributes;
  std::vector<std::uint64_t> first;  ///< for each rank, the position of its first point; last, the number of all points

  /// The rank that owns the point at a position.
  [[nodiscard]] int owner(std::uint64_t position) const {
    return static_cast<int>(std::ranges::upper_bound(first, position) - first.begin()) - 1;
  }
};

/// Sends each point to its owner. Collective. Uses up the points.
[[nodiscard]] OwnPoints send_to_owners(PartOfPoints&& read, const CurveDivision& division, Ranks& ranks,
                                       const Threads& threads);

}  // namespace pardel::engine
