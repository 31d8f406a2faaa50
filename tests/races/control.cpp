// Runs a loop of the engine with or without a data race. Shows whether the race detector understands such loops.
#include <atomic>
#include <cstdio>
#include <cstring>
#include <vector>

#include "../../parallel/threads/parallel_for.hpp"

int main(int argc, char** argv) {
  const bool racy = argc > 1 && std::strcmp(argv[1], "racy") == 0;
  constexpr int threads = 4;
  std::vector<long> sums(threads, 0);
  for (int phase = 0; phase < 20; ++phase) {
    // Each item waits until all items have started, so every thread runs one item. Relaxed accesses do not synchronise
    // the threads.
    std::atomic<int> started{0};
    pardel::engine::parallel_for(threads, threads, [&](std::size_t i, int) {
      started.fetch_add(1, std::memory_order_relaxed);
      while (started.load(std::memory_order_relaxed) < threads) {
      }
      // Within a phase each item writes its own element. The end of a phase is a barrier, so the next phase may access
      // all elements.
      const std::size_t mine = racy ? 0 : (i + static_cast<std::size_t>(phase)) % threads;
      sums[mine] += static_cast<long>(i) + 1;
    });
  }
  std::printf("%ld\n", sums[0]);
  return 0;
}
