#include <algorithm>
#include <utility>

#include "../../core/support/collective.hpp"
#include "../../core/support/stopwatch.hpp"
#include "../conversion/domain_triangulation.hpp"
#include "../distributed.hpp"
#include "../filling/refine_domain.hpp"
#include "../mesher.hpp"
#include "../planning/run_plan.hpp"
#include "../planning/supervised.hpp"
#include "../scheduling/limits.hpp"
#include "piece.hpp"

namespace pardel {

using namespace engine;

namespace {

Error for_one_process(const char* what) {
  return {ErrorKind::usage, std::string(what) + " works in one process only, not in several ranks"};
}

Status check_distributable(const Options& options) {
  if (options.max_vertices > 0) return for_one_process("a limit on the number of vertices");
  if (options.after_sweep) return for_one_process("a function that is called after each sweep");
  return Done{};
}

Result<MeshPiece> mesh_in_ranks(const Pslg& pslg, bool convex_hull, const Goal& goal, const Options& options,
                                ProgressMonitor& progress, Ranks& ranks) {
  Stopwatch watch;
  const Threads threads = progress.threads();
  Result<DomainTriangulation> domain = triangulate_domain(pslg, convex_hull, threads);
  if (!domain) return domain.error();
  Report report;
  report.triangulate_seconds = watch.lap();
  InputData input = input_data(pslg, *domain, threads);
  const Result<RunPlan> plan = plan_run(pslg, goal, *domain, options, threads, report);
  if (!plan) return plan.error();
  if (!plan->edges_of_patches.empty()) return for_one_process("an interior of equilateral triangles");

  if (outgrows_memory(pslg.points.size(), options)) return too_much_memory(options);
  const Options resolved = resolvable(options, domain->triangulation);
  Distribution distribution(ranks, domain->triangulation);
  Result<RefineCounts> counts = refine_by_sweeps(domain->triangulation, domain->segments, plan->criteria, resolved,
                                                 progress, {}, {}, &distribution);
  if (!counts) return counts.error();
  report.refine_seconds = watch.lap();
  write_report(*domain, plan->criteria, resolved, std::move(*counts), threads, report, [&](TriangleId id) {
    return distribution.part().has(id) && distribution.owner_of_triangle(id) == ranks.rank();
  });
  MeshPiece piece = make_piece(*domain, distribution, std::move(input), report.exempt, threads);
  std::ranges::sort(report.exempt, {}, &Exemption::triangle);
  const auto missed = std::ranges::count_if(report.exempt, [](const Exemption& e) { return !justified(e.reason); });
  piece.missed = static_cast<std::uint64_t>(missed);
  ranks.add_up({&piece.missed, 1});
  piece.seconds = watch.lap();
  piece.report = std::move(report);
  return piece;
}

}  // namespace

Result<MeshPiece> mesh(const ValidPslg& domain, const Goal& goal, const Options& options, Ranks& ranks) {
  if (Status in_range = check_goal(goal, options); !in_range) return in_range.error();
  if (Status fits = check_distributable(options); !fits) return fits.error();
  return supervised(options, [&](const Options& safe, ProgressMonitor& progress) {
    return mesh_in_ranks(domain.pslg(), domain.convex_hull() || goal.convex_hull, goal, safe, progress, ranks);
  });
}

Digest digest(const MeshPiece& piece, Ranks& ranks) { return sum_of(digest(piece.mesh), ranks); }

}  // namespace pardel
