// Loops on all cores. The only place that knows OpenMP.
#pragma once

#include <omp.h>

#include <atomic>
#include <cstddef>
#include <new>

namespace pardel {

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

/// The same over blocks of consecutive items: body(first, last, block). The blocks depend on n alone, so what is
/// put together block by block does not depend on threads.
template <class Body>
void parallel_blocks(int threads, std::size_t n, const Body& body) {
  constexpr std::size_t block = 16'384;
  parallel_for(threads, (n + block - 1) / block,
               [&](std::size_t b, int) { body(b * block, b * block + block < n ? b * block + block : n, b); });
}
[[nodiscard]] inline std::size_t block_count(std::size_t n) { return (n + 16'383) / 16'384; }

}  // namespace pardel
