#include "mesh_with_mesher_in_ranks.hpp"

#include <utility>

#include "../core/support/stopwatch.hpp"
#include "../off_the_shelf/schemes/refine_with_mesher.hpp"
#include "../parallel/planning/run_plan.hpp"
#include "../parallel/planning/supervised.hpp"
#include "../parallel/scheduling/refine_domain.hpp"
#include "meshing/check_distributable.hpp"
#include "meshing/distribution.hpp"
#include "meshing/gaps_in_ranks.hpp"
#include "meshing/refine_in_ranks.hpp"

namespace pardel {

using namespace engine;

namespace {

Result<PieceWithMesher> run_in_ranks(const WorkWithMesher& work, const ValidPslg& valid, const Goal& goal,
                                     ProgressMonitor& progress) {
  Stopwatch watch;
  const Pslg& pslg = valid.pslg();
  const Threads threads = progress.threads();
  Ranks& ranks = *work.ranks;
  Result<DomainTriangulation> domain = triangulate_domain(pslg, valid.convex_hull() || goal.convex_hull, threads);
  if (!domain) return domain.error();
  InputData input = input_data(pslg, *domain, threads);
  Report report;
  report.triangulate_seconds = watch.lap();
  report.gaps = gaps_in_ranks(*domain, ranks, threads);
  const Result<RunPlan> plan = plan_run(pslg, goal, *domain, work.options, threads);
  if (!plan) return plan.error();

  PieceWithMesher result;
  if (Status refined = refine_with_mesher(*domain, pslg, *plan, work, progress, result.mesher); !refined)
    return refined.error();

  Distribution distribution(ranks, domain->triangulation, domain->input_of_vertex.span(), input.points.markers);
  Result<MeshPiece> piece = refine_in_ranks(*domain, distribution, plan->criteria, work.options, progress,
                                            std::move(input), std::move(report), watch);
  if (!piece) return piece.error();
  result.piece = std::move(*piece);
  count_all_vertices(result.piece.report, result.mesher);
  return result;
}

}  // namespace

Result<PieceWithMesher> mesh_with_mesher(const ValidPslg& domain, const Goal& goal, SubdomainMesher& mesher,
                                         const MesherOptions& how, const Options& options, Ranks& ranks) {
  if (Status in_range = check_goal(goal, options); !in_range) return in_range.error();
  if (goal.user_test) return Error{ErrorKind::usage, "a test of the user cannot be given to another mesher"};
  if (Status fits = check_distributable(options); !fits) return fits.error();
  return supervised(options, [&](const Options& safe, ProgressMonitor& progress) -> Result<PieceWithMesher> {
    const Result<MesherAbilities> abilities = checked_abilities(mesher, how);
    if (!abilities) return abilities.error();
    return run_in_ranks({mesher, *abilities, how, safe, {}, &ranks}, domain, goal, progress);
  });
}

}  // namespace pardel
