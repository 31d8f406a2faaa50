// What a run has to do to meet a goal.
#pragma once

#include <vector>

#include "../construction/domain_triangulation.hpp"
#include "../options.hpp"
#include "../quality/criteria.hpp"

namespace pardel::engine {

/// The criteria of the refinement, and the patches beside it.
struct RunPlan {
  Goal goal;                 ///< the goal with guarded functions; all its bounds on lengths are `max_edge` and `size`
  std::vector<double> caps;  ///< for each region its area cap; empty without Goal::region_caps
  Criteria criteria;
  /// The lengths of the edges of patches that keep the goal: in each region, and last in triangles without a region.
  /// Empty if the interior is to be refined.
  std::vector<double> edges_of_patches;
};

/// The placement that Placement::automatic stands for. `refines`: a mesh is refined, not a domain.
[[nodiscard]] Placement placement_for(const Goal& goal, const Options& options, bool refines);

/// Plans the refinement of the domain of a valid Pslg. Calls options.before_refinement; its error ends the run.
/// Throws Stopped if the sizes of the goal do not cover the domain.
[[nodiscard]] Result<RunPlan> plan_run(const Pslg& pslg, const Goal& goal, const DomainTriangulation& domain,
                                       const Options& options, const Threads& threads);

}  // namespace pardel::engine
