// Loops and sorts that ask a StopSignal, which may be null. They throw Stopped if the check has to end.
#pragma once

#include <omp.h>

#include <algorithm>
#include <cstddef>

#include "../../../core/support/exception_of.hpp"
#include "../../../core/support/stop_signal.hpp"

namespace pardel::checker {

/// Loops with fewer iterations run on one thread, because waking the other threads takes longer than the loop.
inline constexpr std::size_t parallel_loop_size = 1 << 13;

/// Calls body(first, last, thread) for runs of indices that together are all indices below n, on all threads. Each
/// thread takes consecutive runs of at most 1024 indices, in ascending order, and the threads are in order, too.
template <class Body>
void for_each_run(std::size_t n, StopSignal* stop, const Body& body) {
  constexpr std::size_t run = 1024;  // as many steps as SparseAsk makes between two questions
  std::exception_ptr thrown;
#pragma omp parallel if (n >= parallel_loop_size)
  {
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    bool stopped = false;
#pragma omp for schedule(static)
    for (std::size_t i = 0; i < (n + run - 1) / run; ++i) {
      if (stopped) continue;
      const std::exception_ptr mine = exception_of([&] {
        if (stop != nullptr) stop->ask();
        body(i * run, std::min(n, (i + 1) * run), thread);
      });
      if (!mine) continue;
      stopped = true;
#pragma omp critical(pardel_checker_exception)
      if (!thrown) thrown = mine;
    }
  }
  if (thrown) std::rethrow_exception(thrown);
  if (stop != nullptr && stop->stopped()) stop->ask();
}

/// Calls body(i, thread) for all i < n on all threads. Each thread takes one run of consecutive indices, and the runs
/// have the order of the threads.
template <class Body>
void for_each_index(std::size_t n, StopSignal* stop, const Body& body) {
  for_each_run(n, stop, [&](std::size_t first, std::size_t last, std::size_t thread) {
    for (std::size_t i = first; i < last; ++i) body(i, thread);
  });
}

/// std::sort. If it ends early, the order of the values is unspecified.
template <class Iterator, class Less>
void stoppable_sort(Iterator first, Iterator last, const Less& less, StopSignal* stop) {
  SparseAsk ask(stop);
  std::sort(first, last, [&](const auto& a, const auto& b) {
    ask();
    return less(a, b);
  });
}

}  // namespace pardel::checker
