// Points that are equal, or so close that they are to be.
#pragma once

#include <span>
#include <vector>

#include "../../core/pslg.hpp"

namespace pardel::engine {

/// `first` is the lowest index among the points equal to it; `again` is a later one.
struct Duplicate {
  Index first;
  Index again;
  friend bool operator==(const Duplicate&, const Duplicate&) = default;
};

/// Every point that equals an earlier one, in ascending order of `again`. -0 equals 0; NaN equals nothing.
/// Expected time O(n): a partition by hash, then a table per part that stays in cache; parts on all threads.
[[nodiscard]] std::vector<Duplicate> find_duplicates(std::span<const Point> points, int threads = 1);

/// The same for points closer than `distance` (> 0, finite): in ascending order, every point becomes a duplicate of
/// the lowest earlier point that is no duplicate and closer than that, or equal. So those that stay are at least
/// `distance` apart. Preconditions: coordinates are in the predicates' range. Expected time O(n).
[[nodiscard]] std::vector<Duplicate> find_close(std::span<const Point> points, double distance);

}  // namespace pardel::engine
