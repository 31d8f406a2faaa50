// The bounding box of many points, on all threads.
#pragma once

#include <vector>

#include "lattice.hpp"
#include "parallel_for.hpp"

namespace pardel::engine {

/// The least box with point_of(i) in it, or on its upper sides, for all i below n; `nowhere` where n is 0.
template <class PointOf>
[[nodiscard]] Box bounds_of(int threads, std::size_t n, const PointOf& point_of) {
  std::vector<Box> of_block(block_count(n));
  parallel_blocks(threads, n, [&](std::size_t first, std::size_t last, std::size_t block) {
    Box box = nowhere;
    for (std::size_t i = first; i < last; ++i) {
      const Point p = point_of(i);
      box = united(box, {p.x, p.y, p.x, p.y});
    }
    of_block[block] = box;
  });
  Box all = nowhere;
  for (const Box& box : of_block) all = united(all, box);
  return all;
}

}  // namespace pardel::engine
