#include "refine_with_mesher.hpp"

#include <string>

#include "../../core/support/shortest.hpp"
#include "../../core/support/stopwatch.hpp"
#include "prepare.hpp"
#include "schemes.hpp"

namespace pardel::engine {
namespace {

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

}  // namespace

Result<MesherAbilities> checked_abilities(const SubdomainMesher& mesher, const MesherOptions& how) {
  const auto refuse = [](const std::string& what) { return Error{ErrorKind::usage, what}; };
  const MesherAbilities abilities = mesher.abilities();
  if (how.scheme == Scheme::cells && !abilities.obeys_cell)
    return refuse("the scheme 'cells' needs a mesher that inserts points in a given cell only");
  if (how.scheme != Scheme::cells && !abilities.keeps_frozen_edges)
    return refuse(std::string("the scheme '") + name(how.scheme) + "' needs a mesher that keeps frozen edges");
  if (how.triangles_per_task == 0) return refuse("the triangles per task must be positive, not 0");
  if (!(how.seconds_per_task > 0))
    return refuse("the seconds per task must be positive, not " + shortest(how.seconds_per_task));
  return abilities;
}

Status refine_with_mesher(DomainTriangulation& domain, const Pslg& pslg, const RunPlan& plan,
                          const WorkWithMesher& work, ProgressMonitor& progress, MesherReport& report) {
  const Assessor assessor(domain.triangulation, domain.segments, plan.criteria, work.options);
  MeshInWork mesh{domain.triangulation, domain.segments, assessor};
  MesherCaller mesher(work.mesher, work.abilities);
  MesherRun run{mesh,   plan.goal,  plan.criteria,      work.options, work.how,      plan.caps,
                mesher, work.ranks, progress.threads(), report,       work.show_mesh};
  Stopwatch watch;
  if (Status ready = prepare(run, pslg, domain.triangulation, progress, !mesher.abilities().splits_segments); !ready)
    return ready;
  report.preparation_seconds = watch.lap();
  run_scheme(run);
  report.division_seconds = watch.lap() - run.seconds_in_tasks;
  return Done{};
}

void count_all_vertices(Report& report, MesherReport& mesher) {
  mesher.completed = report.inserted + report.segment_splits;
  report.inserted += mesher.inserted + mesher.prepared;
}

}  // namespace pardel::engine
