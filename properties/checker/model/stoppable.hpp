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

/// The number of shares into which the loops below are divided. A thread that has done its share takes the next one, so
/// a thread that other work of the machine holds up leaves more of them to the others.
inline std::size_t share_count() { return 8 * static_cast<std::size_t>(omp_get_max_threads()); }

/// Calls body(first, last, share) for runs of indices that together are all indices below n, on all threads. A share,
/// from 0 to share_count() - 1, has consecutive runs of at most 1024 indices. One thread does them in ascending order,
/// and the shares are in order, too.
template <class Body>
void for_each_run(std::size_t n, StopSignal* stop, const Body& body) {
  constexpr std::size_t run = 1024;  // as many steps as SparseAsk makes between two questions
  const std::size_t runs = (n + run - 1) / run, shares = share_count();
  std::exception_ptr thrown;
#pragma omp parallel if (n >= parallel_loop_size)
  {
    bool stopped = false;
#pragma omp for schedule(dynamic, 1)
    for (std::size_t share = 0; share < shares; ++share) {
      if (stopped) continue;
      const std::exception_ptr mine = exception_of([&] {
        for (std::size_t i = share * runs / shares; i < (share + 1) * runs / shares; ++i) {
          if (stop != nullptr) stop->ask();
          body(i * run, std::min(n, (i + 1) * run), share);
        }
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

/// Calls body(i, share) for all i < n on all threads. Each share, from 0 to share_count() - 1, has consecutive indices,
/// which one thread takes in ascending order, and the shares are in order, too.
template <class Body>
void for_each_index(std::size_t n, StopSignal* stop, const Body& body) {
  for_each_run(n, stop, [&](std::size_t first, std::size_t last, std::size_t share) {
    for (std::size_t i = first; i < last; ++i) body(i, share);
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
