// Points that are equal.
#pragma once

#include <span>
#include <vector>

#include "../core/pslg.hpp"

namespace pardel {

/// `first` is the lowest index among the points equal to it; `again` is a later one.
struct Duplicate {
  Index first;
  Index again;
  friend bool operator==(const Duplicate&, const Duplicate&) = default;
};

/// Every point that equals an earlier one, in ascending order of `again`. -0 equals 0; NaN equals nothing.
/// Expected time O(n): a partition by hash, then a table per part that stays in cache.
[[nodiscard]] std::vector<Duplicate> find_duplicates(std::span<const Point> points);

}  // namespace pardel
