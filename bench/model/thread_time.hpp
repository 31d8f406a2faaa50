// Processor time of one thread, which other processes on the machine disturb less than elapsed time.
#pragma once

#include <ctime>
#include <utility>

namespace pardel::bench {

/// Seconds of processor time that the calling thread has used.
[[nodiscard]] inline double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Measures the processor time of the thread that makes it.
class ThreadWatch {
 public:
  /// Returns the seconds since the start, or since the last lap(), and starts again from zero.
  double lap() {
    const double now = thread_seconds();
    return now - std::exchange(start_, now);
  }

 private:
  double start_ = thread_seconds();
};

}  // namespace pardel::bench
