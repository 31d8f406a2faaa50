// Parallel loops. The only file of parallel/ that uses OpenMP.
#pragma once

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <new>

namespace pardel::engine {

/// Calls body(i, thread) exactly once for each i in [0, n), on up to `threads` threads. Thread 0 is the caller's. Idle
/// threads take the items one at a time, in ascending order. If a body throws std::bad_alloc, the remaining items are
/// skipped and std::bad_alloc is thrown.
template <class Body>
void parallel_for(int threads, std::size_t n, const Body& body) {
  std::atomic<bool> out_of_memory{false};
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads) if (threads > 1 && n > 1)
  for (std::size_t i = 0; i < n; ++i) {
    if (out_of_memory.load(std::memory_order_relaxed)) continue;
    try {
      body(i, omp_get_thread_num());
    } catch (const std::bad_alloc&) {
      out_of_memory.store(true, std::memory_order_relaxed);
    }
  }
  if (out_of_memory.load()) throw std::bad_alloc();
}

inline constexpr std::size_t items_in_block = 16'384;
[[nodiscard]] inline std::size_t block_count(std::size_t n) { return (n + items_in_block - 1) / items_in_block; }

/// Calls body(first, last, block) for the blocks of consecutive items [first, last) of [0, n), in parallel. The blocks
/// depend on n alone, so a result that is combined block by block does not depend on the number of threads.
template <class Body>
void parallel_blocks(int threads, std::size_t n, const Body& body) {
  parallel_for(threads, block_count(n), [&](std::size_t block, int) {
    const std::size_t first = block * items_in_block;
    body(first, std::min(first + items_in_block, n), block);
  });
}

}  // namespace pardel::engine
