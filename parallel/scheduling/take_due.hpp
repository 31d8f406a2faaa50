// Takes the triangles that are due out of the list of deferred ones, on all threads.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "../../core/array.hpp"
#include "../refinement/deferral.hpp"
#include "../threads/parallel_for.hpp"

namespace pardel::engine {

/// Removes the entries that `later` does not certainly defer (Deferral::defers_by_keys), and returns converted(entry)
/// for each of them. Both lists keep their order. The number of threads does not change the result.
template <class Converted>
[[nodiscard]] auto take_due(const Threads& threads, Array<Deferred>& deferred, const Deferral& later,
                            const Converted& converted) {
  const std::size_t n = deferred.size();
  std::vector<std::size_t> due_before(block_count(n) + 1, 0);
  parallel_blocks(threads, n, [&](std::size_t first, std::size_t last, std::size_t block) {
    due_before[block + 1] = last - first -
                            std::count_if(deferred.begin() + first, deferred.begin() + last,
                                          [&](const Deferred& d) { return later.defers_by_keys(d); });
  });
  std::partial_sum(due_before.begin(), due_before.end(), due_before.begin());
  Array<decltype(converted(deferred[0]))> due;
  due.resize_uninitialised(due_before.back());
  parallel_blocks(threads, n, [&](std::size_t first, std::size_t last, std::size_t block) {
    std::size_t kept = first, found = due_before[block];
    for (std::size_t i = first; i < last; ++i) {
      if (later.defers_by_keys(deferred[i]))
        deferred[kept++] = deferred[i];
      else
        due[found++] = converted(deferred[i]);
    }
  });
  // The entries that stay are now at the front of each block. Move them together.
  std::size_t kept = 0;
  for (std::size_t block = 0, first = 0; first < n; ++block, first += items_in_block) {
    threads.ask();
    const std::size_t stay = std::min(items_in_block, n - first) - (due_before[block + 1] - due_before[block]);
    std::copy_n(deferred.begin() + first, stay, deferred.begin() + kept);
    kept += stay;
  }
  deferred.resize_uninitialised(kept);
  deferred.shrink_to_fit();
  return due;
}

}  // namespace pardel::engine
