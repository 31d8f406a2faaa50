// Does the race detector see what the engine's loops do? The same loop with a race that it has to report, and without.
#include <atomic>
#include <cstdio>
#include <cstring>
#include <vector>

#include "../../parallel/concurrency/parallel_for.hpp"

int main(int argc, char** argv) {
  const bool racy = argc > 1 && std::strcmp(argv[1], "racy") == 0;
  constexpr int threads = 4;
  std::vector<long> sums(threads, 0);
  for (int phase = 0; phase < 20; ++phase) {
    // Nobody finishes before all have started, so that every thread has an item; relaxed, which orders nothing.
    std::atomic<int> started{0};
    pardel::parallel_for(threads, threads, [&](std::size_t i, int) {
      started.fetch_add(1, std::memory_order_relaxed);
      while (started.load(std::memory_order_relaxed) < threads) {
      }
      // A phase may read what the phase before it wrote: its end is a barrier. Within a phase each has its own.
      const std::size_t mine = racy ? 0 : (i + static_cast<std::size_t>(phase)) % threads;
      sums[mine] += static_cast<long>(i) + 1;
    });
  }
  std::printf("%ld\n", sums[0]);
  return 0;
}
