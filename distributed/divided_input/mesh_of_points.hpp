// A mesh that several ranks make of a domain that none of them has as a whole.
#pragma once

#include "../../core/part_of_points.hpp"
#include "../../parallel/scheduling/progress_monitor.hpp"
#include "../distributed.hpp"

namespace pardel::engine {

/// As mesh() of a PartOfPslg (distributed.hpp), for a goal and options that can_divide_points() accepts. Collective.
/// Throws Stopped if the run has to end.
[[nodiscard]] Result<MeshPiece> mesh_of_points(PartOfPslg&& input, const Goal& goal, const Options& options,
                                               ProgressMonitor& progress, Ranks& ranks);

}  // namespace pardel::engine
