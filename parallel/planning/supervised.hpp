// Runs with the functions of the caller, which may throw or ask to stop.
#pragma once

#include <utility>

#include "../scheduling/progress_monitor.hpp"
#include "../sizing/guarded.hpp"

namespace pardel::engine {

/// The options of a run for this goal: one thread if Goal::user_test may have state.
[[nodiscard]] inline Options options_for(const Goal& goal, Options options) {
  if (goal.user_test && !goal.user_test_is_free_of_state) options.threads = 1;
  return options;
}

/// Returns work(safe, progress). `safe` is a copy of the options in which the functions of the caller are guarded. Work
/// that has to end early, or runs out of memory, becomes an error.
template <class Work>
auto supervised(const Options& options, const Work& work)
    -> decltype(work(options, std::declval<ProgressMonitor&>())) try {
  const Options safe = guarded(options);
  ProgressMonitor progress(safe);
  return work(safe, progress);
} catch (const Stopped& stopped) {
  return stopped.error;
} catch (...) {
  return error_of_exception();
}

}  // namespace pardel::engine
