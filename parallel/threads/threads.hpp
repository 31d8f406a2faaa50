// The number of threads of a run, together with the signal that ends the run early.
#pragma once

#include "../../core/support/stop_signal.hpp"

namespace pardel::engine {

/// Converts from a number of threads. Such a run does not end early.
struct Threads {
  Threads(int threads = 1, StopSignal* signal = nullptr) : count(threads < 1 ? 1 : threads), stop(signal) {}

  int count;         ///< >= 1
  StopSignal* stop;  ///< may be null

  /// Throws Stopped if the run has to end.
  void ask() const {
    if (stop != nullptr) stop->ask();
  }
};

}  // namespace pardel::engine
