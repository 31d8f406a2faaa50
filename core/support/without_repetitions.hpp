// Lists in which each value occurs once.
#pragma once

#include <algorithm>
#include <vector>

namespace pardel {

/// Sorts the values. Of equal ones, one is left.
template <class T>
void sort_without_repetitions(std::vector<T>& values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace pardel
