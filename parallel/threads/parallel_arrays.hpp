// Arrays that are built in parallel. Their content does not depend on the number of threads.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "../../core/array.hpp"
#include "../../core/pslg.hpp"
#include "index_allocator.hpp"
#include "parallel_for.hpp"

namespace pardel::engine {

/// Appends the blocks, which are lists or spans of T, to `all`, in the order of the blocks.
template <class Block, class T>
void append_blocks(const Threads& threads, const std::vector<Block>& blocks, Array<T>& all) {
  std::vector<std::size_t> start(blocks.size() + 1, all.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) start[b + 1] = start[b] + blocks[b].size();
  all.resize_uninitialised(start.back());
  parallel_runs(threads, blocks.size(),
                [&](std::size_t b) { std::copy(blocks[b].begin(), blocks[b].end(), all.begin() + start[b]); });
}

/// The indices i < n with satisfies(i), in ascending order.
template <class Satisfies>
[[nodiscard]] Array<Index> indices_where(const Threads& threads, std::size_t n, const Satisfies& satisfies) {
  std::vector<std::vector<Index>> found(block_count(n));
  parallel_blocks(threads, n, [&](std::size_t first, std::size_t last, std::size_t block) {
    for (std::size_t i = first; i < last; ++i)
      if (satisfies(i)) found[block].push_back(static_cast<Index>(i));
  });
  Array<Index> all;
  append_blocks(threads, found, all);
  return all;
}

/// The array of make(0), ..., make(n - 1).
template <class Make>
[[nodiscard]] auto make_array(const Threads& threads, std::size_t n, const Make& make) {
  Array<decltype(make(std::size_t{}))> made;
  made.resize_uninitialised(n);
  parallel_blocks(threads, n, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) made[i] = make(i);
  });
  return made;
}

/// For all i < n: the place of i in the list, or no_index. Precondition: the list has different indices below n.
[[nodiscard]] inline Array<Index> places_in(const Threads& threads, std::span<const Index> list, std::size_t n) {
  Array<Index> place = make_array(threads, n, [](std::size_t) { return no_index; });
  parallel_blocks(threads, list.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) place[list[i]] = static_cast<Index>(i);
  });
  return place;
}

/// Calls visit(cell_of[i], i) for all i with cell_of[i] < cells. The calls for one cell are made by one thread, in
/// ascending order of i; the calls for different cells may be concurrent. Each thread is responsible for a range of
/// cells and reads all of cell_of, which costs little compared with the visits.
template <class Visit>
void visit_by_cell(const Threads& threads, std::span<const Index> cell_of, std::size_t cells, const Visit& visit) {
  const std::size_t groups = std::min(cells, static_cast<std::size_t>(threads.count));
  parallel_for(threads, groups, [&](std::size_t group, int) {
    const std::size_t first = cells * group / groups, last = cells * (group + 1) / groups;
    SparseAsk ask(threads.stop);
    for (std::size_t i = 0; i < cell_of.size(); ++i) {
      ask();
      if (cell_of[i] >= first && cell_of[i] < last) visit(cell_of[i], i);
    }
  });
}

/// The same for all i < n, with a function cell_of(i) instead of an array. It is called once for each i.
template <class CellOf, class Visit>
void visit_by_cell(const Threads& threads, std::size_t n, std::size_t cells, const CellOf& cell_of,
                   const Visit& visit) {
  const Array<Index> cell = make_array(threads, n, cell_of);
  visit_by_cell(threads, cell.span(), cells, visit);
}

/// Calls body(from, to) for all moves, in parallel.
template <class Body>
void for_each_move(const Threads& threads, const IndexMoves& moves, const Body& body) {
  parallel_blocks(threads, moves.end() - moves.in_use(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) {
      const auto from = static_cast<Index>(moves.in_use() + i);
      if (const Index to = moves.now(from); to != no_index) body(from, to);
    }
  });
}

}  // namespace pardel::engine
