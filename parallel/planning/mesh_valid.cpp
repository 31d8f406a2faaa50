#include "mesh_valid.hpp"

#include <utility>

#include "../../core/support/stopwatch.hpp"
#include "../construction/domain_triangulation.hpp"
#include "../conversion/export_mesh.hpp"
#include "../diagnosis/find_gaps.hpp"
#include "../filling/refine_filled.hpp"
#include "../scheduling/refine_domain.hpp"
#include "../triangulation/limits.hpp"
#include "run_plan.hpp"

namespace pardel::engine {
namespace {

/// Refines the triangulation of a valid Pslg until it meets the goal.
Result<Mesh> refined_mesh(const Pslg& pslg, bool convex_hull, const Goal& goal, DomainTriangulation domain,
                          InputData input, const Options& options, ProgressMonitor& progress, Report& report) {
  report.gaps = find_gaps(domain, progress.threads());
  Result<RunPlan> plan = plan_run(pslg, goal, domain, options, progress.threads());
  if (!plan) return plan.error();
  if (plan->edges_of_patches.empty())
    return refine_domain(std::move(domain), plan->criteria, std::move(input), options, progress, report);
  return refine_filled({pslg, convex_hull, std::move(plan->edges_of_patches)}, std::move(domain), plan->criteria, input,
                       options, progress, report);
}

}  // namespace

Result<Meshed> mesh_valid(const Pslg& pslg, bool convex_hull, const Goal* goal, const Options& options,
                          ProgressMonitor& progress) {
  Stopwatch watch;
  Meshed result;
  if (outgrows_memory(pslg.points.size(), options)) return too_much_memory(options);
  progress.expect(static_cast<double>(pslg.points.size()));
  Result<DomainTriangulation> domain = triangulate_domain(pslg, convex_hull, progress.threads());
  if (!domain) return domain.error();
  InputData input = input_data(pslg, *domain, progress.threads());
  result.report.triangulate_seconds = watch.lap();

  Result<Mesh> mesh = goal == nullptr ? Result<Mesh>(to_mesh(std::move(*domain), std::move(input), progress.threads()))
                                      : refined_mesh(pslg, convex_hull, *goal, std::move(*domain), std::move(input),
                                                     options, progress, result.report);
  if (!mesh) return mesh.error();
  result.mesh = std::move(*mesh);
  result.report.refine_seconds = watch.lap();
  return result;
}

}  // namespace pardel::engine
