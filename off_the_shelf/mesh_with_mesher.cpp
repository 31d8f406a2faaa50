#include "mesh_with_mesher.hpp"

#include <utility>

#include "../core/support/enum_names.hpp"
#include "../core/support/stopwatch.hpp"
#include "../parallel/diagnosis/find_gaps.hpp"
#include "../parallel/planning/supervised.hpp"
#include "../parallel/scheduling/refine_domain.hpp"
#include "schemes/refine_with_mesher.hpp"

namespace pardel {

using namespace engine;

namespace {

Result<MeshedWithMesher> run_with(SubdomainMesher& mesher, const MesherAbilities& abilities, const ValidPslg& valid,
                                  const Goal& goal, const MesherOptions& how, const Options& options,
                                  ProgressMonitor& progress) {
  Stopwatch watch;
  const Pslg& pslg = valid.pslg();
  const Threads threads = progress.threads();
  MeshedWithMesher result;
  Result<DomainTriangulation> domain = triangulate_domain(pslg, valid.convex_hull() || goal.convex_hull, threads);
  if (!domain) return domain.error();
  InputData input = input_data(pslg, *domain, threads);
  result.report.triangulate_seconds = watch.lap();
  result.report.gaps = find_gaps(*domain, threads);
  const Result<RunPlan> plan = plan_run(pslg, goal, *domain, options, threads);
  if (!plan) return plan.error();

  const WorkWithMesher work{mesher, abilities, how, options,
                            watcher(*domain, options, [&](DomainTriangulation&& snapshot) -> Result<Mesh> {
                              return to_mesh(std::move(snapshot), input, threads);
                            })};
  if (Status refined = refine_with_mesher(*domain, pslg, *plan, work, progress, result.mesher); !refined)
    return refined.error();

  Result<Mesh> mesh =
      refine_domain(std::move(*domain), plan->criteria, std::move(input), options, progress, result.report);
  if (!mesh) return mesh.error();
  result.mesh = std::move(*mesh);
  count_all_vertices(result.report, result.mesher);
  result.report.refine_seconds = watch.lap();
  return result;
}

}  // namespace

const char* name(Scheme scheme) {
  constexpr auto names =
      enum_names<Scheme>({{Scheme::frozen, "frozen"}, {Scheme::cells, "cells"}, {Scheme::decoupled, "decoupled"}});
  return names[scheme];
}

Result<MeshedWithMesher> mesh_with_mesher(const ValidPslg& domain, const Goal& goal, SubdomainMesher& mesher,
                                          const MesherOptions& how, const Options& options) {
  if (Status in_range = check_goal(goal, options); !in_range) return in_range.error();
  if (goal.user_test) return Error{ErrorKind::usage, "a test of the user cannot be given to another mesher"};
  return supervised(options, [&](const Options& safe, ProgressMonitor& progress) -> Result<MeshedWithMesher> {
    const Result<MesherAbilities> abilities = checked_abilities(mesher, how);
    if (!abilities) return abilities.error();
    return run_with(mesher, *abilities, domain, goal, how, safe, progress);
  });
}

}  // namespace pardel
