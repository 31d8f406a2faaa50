// Loops and sorts that ask a StopSignal, which may be null. They throw Stopped if the check has to end.
#pragma once

#include <omp.h>

#include <algorithm>
#include <cstddef>
#include <exception>

#include "../../../core/support/stop_signal.hpp"

namespace pardel::checker {

/// Loops with fewer iterations run on one thread, because waking the other threads takes longer than the loop.
inline constexpr std::size_t parallel_loop_size = 1 << 13;

/// Calls body(i, thread) for all i < n on all threads. Each thread takes one run of consecutive indices, and the runs
/// have the order of the threads.
template <class Body>
void for_each_index(std::size_t n, StopSignal* stop, const Body& body) {
  std::exception_ptr thrown;
#pragma omp parallel if (n >= parallel_loop_size)
  {
    const auto thread = static_cast<std::size_t>(omp_get_thread_num());
    SparseAsk ask(stop);
    bool stopped = false;
#pragma omp for schedule(static)
    for (std::size_t i = 0; i < n; ++i) {
      if (stopped) continue;
      try {  // an exception may not leave a parallel loop
        ask();
        body(i, thread);
      } catch (...) {
        stopped = true;
#pragma omp critical(pardel_checker_exception)
        if (!thrown) thrown = std::current_exception();
      }
    }
  }
  if (thrown) std::rethrow_exception(thrown);
  if (stop != nullptr && stop->stopped()) stop->ask();
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
