// Loops on all cores. The only place in parallel/ that knows OpenMP.
#pragma once

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <new>

namespace pardel::engine {

/// Calls body(i, thread) for i in [0, n), each once, on up to `threads` threads, thread 0 being the caller. Items
/// are given out one by one, in order, to whoever is free. A std::bad_alloc in a body ends the loop early and is
/// thrown on.
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

/// The same over blocks of consecutive items: body(first, last, block). The blocks depend on n alone, so what is
/// put together block by block does not depend on threads.
template <class Body>
void parallel_blocks(int threads, std::size_t n, const Body& body) {
  parallel_for(threads, block_count(n), [&](std::size_t block, int) {
    const std::size_t first = block * items_in_block;
    body(first, std::min(first + items_in_block, n), block);
  });
}

}  // namespace pardel::engine
