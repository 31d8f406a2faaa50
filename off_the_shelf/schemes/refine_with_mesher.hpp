// The part of a run in which a sequential mesher refines the domain; the same in one process and in several ranks.
#pragma once

#include "../../core/ranks.hpp"
#include "../../parallel/construction/domain_triangulation.hpp"
#include "../../parallel/planning/run_plan.hpp"
#include "../../parallel/scheduling/refine_by_sweeps.hpp"
#include "../mesh_with_mesher.hpp"

namespace pardel::engine {

/// What the mesher can do. Errors: `usage` if it cannot serve the scheme, or if a number of `how` is not positive.
/// Throws what the mesher throws.
[[nodiscard]] Result<MesherAbilities> checked_abilities(const SubdomainMesher& mesher, const MesherOptions& how);

/// Who refines, and how.
struct WorkWithMesher {
  SubdomainMesher& mesher;
  MesherAbilities abilities;
  const MesherOptions& how;
  const Options& options;
  Watcher show_mesh{};     ///< see Options::after_sweep
  Ranks* ranks = nullptr;  ///< they share the tasks; null: one process
};

/// Lets the mesher refine the domain. Afterwards it is constrained Delaunay, but need not meet the goal everywhere.
/// Collective if there are ranks: all have the same domain before and afterwards. Throws Stopped if
/// the run has to end.
[[nodiscard]] Status refine_with_mesher(DomainTriangulation& domain, const Pslg& pslg, const RunPlan& plan,
                                        const WorkWithMesher& work, ProgressMonitor& progress, MesherReport& report);

/// To be called after pardel's own refiner has completed the mesh, whose vertices `report` counts so far: counts all.
void count_all_vertices(Report& report, MesherReport& mesher);

}  // namespace pardel::engine
