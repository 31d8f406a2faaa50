// The coarse mesh with which a run begins.
#pragma once

#include "../../core/result.hpp"
#include "../../parallel/scheduling/progress_monitor.hpp"
#include "../subdomains/run_tasks.hpp"

namespace pardel::engine {

/// Refines the mesh with the sizes of the goal times coarseness, so that it can be divided. `split_segments`: the
/// segments are split to their final length already. Does nothing if the goal has no sizes, or if one task can make the
/// whole mesh. `pslg`: the valid domain.
[[nodiscard]] Status prepare(MesherRun& run, const Pslg& pslg, Triangulation& t, ProgressMonitor& progress,
                             bool split_segments);

}  // namespace pardel::engine
