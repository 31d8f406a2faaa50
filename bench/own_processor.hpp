// Binds a rank to a processor of its own.
#pragma once

#include <sched.h>

namespace pardel::bench {

/// While it lives, the calling thread runs on one processor only: the n-th of those that it may use. This is what
/// mpirun does for two ranks if no --bind-to is given. Without it, the system may let two ranks that wait for each
/// other take turns on one processor. If there are fewer than `ranks` processors, nothing is bound.
class OwnProcessor {
 public:
  OwnProcessor(int n, int ranks) {
    if (sched_getaffinity(0, sizeof before_, &before_) != 0 || CPU_COUNT(&before_) < ranks) return;
    cpu_set_t one;
    CPU_ZERO(&one);
    for (int processor = 0, seen = 0; processor < CPU_SETSIZE; ++processor)
      if (CPU_ISSET(processor, &before_) && seen++ == n) CPU_SET(processor, &one);
    is_bound_ = sched_setaffinity(0, sizeof one, &one) == 0;
  }
  OwnProcessor(const OwnProcessor&) = delete;
  OwnProcessor& operator=(const OwnProcessor&) = delete;
  ~OwnProcessor() {
    if (is_bound_) sched_setaffinity(0, sizeof before_, &before_);
  }

 private:
  cpu_set_t before_{};
  bool is_bound_ = false;
};

}  // namespace pardel::bench
