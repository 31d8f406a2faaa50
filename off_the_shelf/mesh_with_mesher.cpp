#include "mesh_with_mesher.hpp"

#include <string>
#include <utility>

#include "../core/support/enum_names.hpp"
#include "../core/support/shortest.hpp"
#include "../core/support/stopwatch.hpp"
#include "../parallel/diagnosis/find_gaps.hpp"
#include "../parallel/planning/run_plan.hpp"
#include "../parallel/planning/supervised.hpp"
#include "../parallel/scheduling/refine_domain.hpp"
#include "../parallel/sizing/graded_size.hpp"
#include "schemes/prepare.hpp"
#include "schemes/schemes.hpp"

namespace pardel {

using namespace engine;

namespace {

Status check(const MesherOptions& how, const MesherAbilities& mesher) {
  const auto refuse = [](const std::string& what) { return Error{ErrorKind::usage, what}; };
  if (how.scheme == Scheme::cells && !mesher.obeys_cell)
    return refuse("the scheme 'cells' needs a mesher that inserts points in a given cell only");
  if (how.scheme != Scheme::cells && !mesher.keeps_frozen_edges)
    return refuse(std::string("the scheme '") + name(how.scheme) + "' needs a mesher that keeps frozen edges");
  if (how.triangles_per_task == 0) return refuse("the triangles per task must be positive, not 0");
  if (!(how.seconds_per_task > 0))
    return refuse("the seconds per task must be positive, not " + shortest(how.seconds_per_task));
  return Done{};
}

void run_scheme(MesherRun& run) {
  switch (run.how.scheme) {
    case Scheme::frozen:
      return sweep_with_frozen_borders(run);
    case Scheme::cells:
      return sweep_over_cells(run);
    case Scheme::decoupled:
      return refine_decoupled(run);
  }
}

Result<MeshedWithMesher> run_with(SubdomainMesher& mesher, const ValidPslg& valid, const Goal& goal,
                                  const MesherOptions& how, const Options& options, ProgressMonitor& progress) {
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

  const Assessor assessor(domain->triangulation, domain->segments, plan->criteria, options);
  MeshInWork in_work{domain->triangulation, domain->segments, assessor};
  const Watcher show_mesh = watcher(*domain, options, [&](DomainTriangulation&& snapshot) -> Result<Mesh> {
    return to_mesh(std::move(snapshot), input, threads);
  });
  MesherRun run{in_work,    plan->goal, plan->criteria, options,       how,
                plan->caps, mesher,     threads,        result.mesher, show_mesh};
  if (Status ready = prepare(run, pslg, domain->triangulation, progress, !mesher.abilities().splits_segments); !ready)
    return ready.error();
  run_scheme(run);

  Result<Mesh> mesh =
      refine_domain(std::move(*domain), plan->criteria, std::move(input), options, progress, result.report);
  if (!mesh) return mesh.error();
  result.mesh = std::move(*mesh);
  result.mesher.completed = result.report.inserted + result.report.segment_splits;
  result.report.inserted += result.mesher.inserted + result.mesher.prepared;
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
  if (Status fits = check(how, mesher.abilities()); !fits) return fits.error();
  return supervised(options, [&](const Options& safe, ProgressMonitor& progress) {
    return run_with(mesher, domain, goal, how, safe, progress);
  });
}

}  // namespace pardel
