// The steps that make the mesh of a valid domain.
#pragma once

#include "../mesher.hpp"
#include "../scheduling/progress_monitor.hpp"

namespace pardel::engine {

/// As mesh() (mesher.hpp) for a valid Pslg, or only its constrained Delaunay triangulation if `goal` is null. Throws
/// Stopped if the run has to end.
[[nodiscard]] Result<Meshed> mesh_valid(const Pslg& pslg, bool convex_hull, const Goal* goal, const Options& options,
                                        ProgressMonitor& progress);

}  // namespace pardel::engine
