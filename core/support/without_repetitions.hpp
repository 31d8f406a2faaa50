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

/// The same for unsigned integers below `end`. O(values + end), so it is faster for lists that are not short.
template <class T>
void sort_without_repetitions(std::vector<T>& values, T end) {
  std::vector<char> occurs(end, 0);
  for (const T value : values) occurs[value] = 1;
  values.clear();
  for (T value = 0; value < end; ++value)
    if (occurs[value] != 0) values.push_back(value);
}

}  // namespace pardel
