// The bounding box of many points, computed in parallel.
#pragma once

#include <vector>

#include "../arithmetic/box.hpp"
#include "../threads/parallel_for.hpp"

namespace pardel::engine {

/// The smallest closed box that contains point_of(i) for all i < n; `empty_box` if n is 0. Uses up to `threads`
/// threads. The number of threads does not change the result. O(n).
template <class PointOf>
[[nodiscard]] Box bounding_box(const Threads& threads, std::size_t n, const PointOf& point_of) {
  std::vector<Box> of_block(block_count(n));
  parallel_blocks(threads, n, [&](std::size_t first, std::size_t last, std::size_t block) {
    Box box = empty_box;
    for (std::size_t i = first; i < last; ++i) box.cover(Box::around(point_of(i)));
    of_block[block] = box;
  });
  Box all = empty_box;
  for (const Box& box : of_block) all.cover(box);
  return all;
}

}  // namespace pardel::engine
