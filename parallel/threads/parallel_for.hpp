// Parallel loops. The only file of parallel/ that uses OpenMP.
#pragma once

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>

#include "threads.hpp"

namespace pardel::engine {

/// Below this number of points or triangles, more threads take longer than one: they wait for each other.
inline constexpr double fewest_for_threads = 30'000;

/// The number of threads to use for this number of points or triangles: `wanted`; if it is not positive, as many as
/// OpenMP offers, or one if there are so few items that more do not pay.
[[nodiscard]] inline int thread_count(int wanted, double items = INFINITY) {
  if (wanted > 0) return wanted;
  return items < fewest_for_threads ? 1 : omp_get_max_threads();
}

/// Of the exceptions that the items of a loop throw: the exception of the first item.
class FirstException {
 public:
  /// True if an item before item i has thrown.
  [[nodiscard]] bool is_before(std::size_t i) const { return item_.load(std::memory_order_relaxed) < i; }
  /// Calls work(), a part of item i, and keeps its exception.
  template <class Work>
  void guard(std::size_t i, const Work& work) {
    try {
      work();
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (i >= item_) return;
      item_ = i;
      exception_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  std::atomic<std::size_t> item_{SIZE_MAX};
  std::exception_ptr exception_;
  std::mutex mutex_;
};

/// Lets the caller's thread wait for the other threads of a loop.
class Finish {
 public:
  /// The other threads call this at the end.
  void thread_finished() {
    const std::scoped_lock lock(mutex_);
    ++finished_;
    last_finished_.notify_one();
  }
  /// Waits until `others` threads have finished. Calls ask() meanwhile: only the caller's thread can ask the caller.
  template <class Ask>
  void wait_for(int others, const Ask& ask) {
    std::unique_lock lock(mutex_);
    while (!last_finished_.wait_for(lock, StopSignal::usual_interval, [&] { return finished_ >= others; })) {
      lock.unlock();
      ask();
      lock.lock();
    }
  }

 private:
  std::mutex mutex_;
  std::condition_variable last_finished_;
  int finished_ = 0;
};

/// Calls body(i, thread) exactly once for each i in [0, n), on up to `threads` threads. Thread 0 is the caller's. Idle
/// threads take the items one at a time, in ascending order. If a body throws, later items are skipped, and the loop
/// throws the exception of the first item that throws. So the exception does not depend on the number of threads. Asks
/// before each item (Threads::ask); if the run has to end, no further item starts, and the loop throws Stopped.
template <class Body>
void parallel_for(const Threads& threads, std::size_t n, const Body& body) {
  FirstException first;
  Finish finish;
#pragma omp parallel num_threads(threads.count) if (threads.count > 1 && n > 1)
  {
    const int thread = omp_get_thread_num();
#pragma omp for schedule(dynamic, 1) nowait
    for (std::size_t i = 0; i < n; ++i) {
      if (first.is_before(i)) continue;
      first.guard(i, [&] {
        threads.ask();
        body(i, thread);
      });
    }
    if (thread > 0)
      finish.thread_finished();
    else if (threads.stop != nullptr)
      finish.wait_for(omp_get_num_threads() - 1, [&] { first.guard(n, [&] { threads.ask(); }); });
  }
  first.rethrow();
}

/// The same for many small items that write consecutive parts of an array: a thread takes a run of consecutive items at
/// a time, so that two threads seldom write to the same page of memory. A page that two threads touch first at the same
/// time is cleared twice by the operating system, and to clear fresh pages takes as long as to fill them.
template <class Body>
void parallel_runs(const Threads& threads, std::size_t n, const Body& body) {
  constexpr std::size_t runs_per_thread = 8;
  const std::size_t runs = std::min(n, runs_per_thread * static_cast<std::size_t>(threads.count));
  parallel_for(threads, runs, [&](std::size_t run, int) {
    const std::size_t first = n * run / runs, end = n * (run + 1) / runs;
    for (std::size_t i = first; i < end; ++i) {
      if (i > first) threads.ask();
      body(i);
    }
  });
}

inline constexpr std::size_t items_in_block = 16'384;
[[nodiscard]] inline std::size_t block_count(std::size_t n) { return (n + items_in_block - 1) / items_in_block; }

/// Calls body(first, last, block) for the blocks of consecutive items [first, last) of [0, n), in parallel. The blocks
/// depend on n alone, so a result that is combined block by block does not depend on the number of threads.
template <class Body>
void parallel_blocks(const Threads& threads, std::size_t n, const Body& body) {
  parallel_runs(threads, block_count(n), [&](std::size_t block) {
    const std::size_t first = block * items_in_block;
    body(first, std::min(first + items_in_block, n), block);
  });
}

}  // namespace pardel::engine
