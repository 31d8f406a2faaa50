// Lets a test control the order in which the tasks of a phase run.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace pardel::engine {

/// Hooks into the execution of a phase. Tests use them to show that the mesh does not depend on the order. All hooks
/// are optional.
struct Schedule {
  /// Permutes the order in which the tasks are started. By default, the largest task comes first.
  std::function<void(std::vector<std::size_t>&)> order{};
  /// Called with the number of a task, by the thread that is about to start it.
  std::function<void(std::size_t task)> before_task{};
  std::function<void()> after_phase{};
  /// Interleaves the tasks: one thread runs all tasks of a phase together, one insertion at a time. Called before each
  /// insertion with the number n of unfinished tasks. Returns which of them, 0 to n - 1, makes the next insertion.
  std::function<std::size_t(std::size_t n)> next{};
};

}  // namespace pardel::engine
