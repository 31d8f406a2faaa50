// Lists that many threads make at once, in an order that does not depend on how many.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "../../core/array.hpp"
#include "../../core/pslg.hpp"
#include "parallel_for.hpp"

namespace pardel::engine {

/// Appends what was found block by block: lists or spans of T.
template <class Block, class T>
void append_blocks(int threads, const std::vector<Block>& blocks, Array<T>& all) {
  std::vector<std::size_t> start(blocks.size() + 1, all.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) start[b + 1] = start[b] + blocks[b].size();
  all.resize_uninitialised(start.back());
  parallel_for(threads, blocks.size(),
               [&](std::size_t b, int) { std::copy(blocks[b].begin(), blocks[b].end(), all.begin() + start[b]); });
}

/// The i below n that satisfy, in ascending order.
template <class Satisfies>
[[nodiscard]] Array<Index> indices_where(int threads, std::size_t n, const Satisfies& satisfies) {
  std::vector<std::vector<Index>> found(block_count(n));
  parallel_blocks(threads, n, [&](std::size_t first, std::size_t last, std::size_t block) {
    for (std::size_t i = first; i < last; ++i)
      if (satisfies(i)) found[block].push_back(static_cast<Index>(i));
  });
  Array<Index> all;
  append_blocks(threads, found, all);
  return all;
}

/// An array of n elements that a function of the index makes.
template <class Make>
[[nodiscard]] auto make_array(int threads, std::size_t n, const Make& make) {
  Array<decltype(make(std::size_t{}))> made;
  made.resize_uninitialised(n);
  parallel_blocks(threads, n, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) made[i] = make(i);
  });
  return made;
}

/// Calls file(cell_of[i], i) for all i whose cell is below `cells`: for each cell in ascending order of i, one call at
/// a time. Every thread has some cells and looks at all of cell_of, which is little beside what filing costs.
template <class File>
void file_by_cell(int threads, std::span<const Index> cell_of, std::size_t cells, const File& file) {
  const std::size_t groups = std::min(cells, static_cast<std::size_t>(std::max(1, threads)));
  parallel_for(threads, groups, [&](std::size_t group, int) {
    const std::size_t first = cells * group / groups, last = cells * (group + 1) / groups;
    for (std::size_t i = 0; i < cell_of.size(); ++i)
      if (cell_of[i] >= first && cell_of[i] < last) file(cell_of[i], i);
  });
}

/// The same for i below n, with the cells that cell_of(i) gives.
template <class CellOf, class File>
void file_by_cell(int threads, std::size_t n, std::size_t cells, const CellOf& cell_of, const File& file) {
  const Array<Index> cell = make_array(threads, n, cell_of);
  file_by_cell(threads, cell.span(), cells, file);
}

}  // namespace pardel::engine
