// The tasks of a phase, divided among ranks.
#pragma once

#include <cstddef>
#include <span>

#include "../../core/ranks.hpp"
#include "attempt.hpp"

namespace pardel::engine {

/// True if this rank does the task.
[[nodiscard]] inline bool does_task(std::size_t task, const Ranks& ranks) {
  return task % static_cast<std::size_t>(ranks.count()) == static_cast<std::size_t>(ranks.rank());
}

/// The one exchange of a phase: each rank sends to all others what became of its tasks. All ranks have the same tasks,
/// and have taken out the parts of all of them. Afterwards all have the same attempts. Collective. Throws Stopped with
/// an internal error for a message that does not fit. O(n) for n triangles of all answers.
void share_attempts(std::span<Attempt> attempts, Ranks& ranks);

}  // namespace pardel::engine
