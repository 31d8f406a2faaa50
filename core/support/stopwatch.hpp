// Measures elapsed time with a clock that never goes back.
#pragma once

#include <chrono>

namespace pardel {

/// The constructor starts the stopwatch.
class Stopwatch {
 public:
  /// Seconds since the start, or since the last lap().
  [[nodiscard]] double seconds() const { return between(start_, Clock::now()); }

  /// Returns seconds() and starts again from zero.
  double lap() {
    const Clock::time_point last = start_;
    start_ = Clock::now();
    return between(last, start_);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double between(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
  }

  Clock::time_point start_ = Clock::now();
};

}  // namespace pardel
