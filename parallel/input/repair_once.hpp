// Repair with a given snapping distance.
#pragma once

#include <optional>
#include <vector>

#include "../../core/support/stop_signal.hpp"
#include "../repair.hpp"

namespace pardel::engine {

/// The problems that repair() cannot remove. Both functions ask `stop`.
[[nodiscard]] std::vector<Problem> find_unusable_values(const Pslg& pslg, StopSignal& stop);

/// As repair() with the snapping distance `snap`. Nothing if splitting the segments where they meet makes ever more
/// crossings. Precondition: there are no unusable values.
[[nodiscard]] std::optional<Result<Repaired>> repair_once(const Pslg& pslg, double snap, bool convex_hull,
                                                          StopSignal& stop);

}  // namespace pardel::engine
