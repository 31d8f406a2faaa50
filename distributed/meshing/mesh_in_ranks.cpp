#include "mesh_in_ranks.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "../../core/support/collective.hpp"
#include "../../core/support/exchange_lists.hpp"
#include "../../core/support/stopwatch.hpp"
#include "../../parallel/construction/domain_triangulation.hpp"
#include "../../parallel/planning/run_plan.hpp"
#include "../../parallel/scheduling/refine_domain.hpp"
#include "../../parallel/triangulation/limits.hpp"
#include "filled_pieces.hpp"
#include "gaps_in_ranks.hpp"
#include "piece.hpp"
#include "refine_in_ranks.hpp"

namespace pardel::engine {
namespace {

/// What is around the patches is the same on all ranks, because the engine is deterministic. This verifies it.
void check_alike(const Mesh& around, Ranks& ranks) {
  const Digest here = digest(around);
  for (const std::vector<Digest>& there : lists_of_all(std::vector{here}, ranks))
    if (there != std::vector{here})
      throw Stopped{{ErrorKind::internal, "the ranks have different meshes around the equilateral triangles"}};
}

/// Makes a mesh in pieces.
class RunInRanks {
 public:
  RunInRanks(const Pslg& pslg, bool convex_hull, const Options& options, ProgressMonitor& progress, Ranks& ranks,
             int pieces, const VisitPiece& visit)
      : pslg_(pslg),
        convex_hull_(convex_hull),
        options_(options),
        progress_(progress),
        threads_(progress.threads()),
        ranks_(ranks),
        pieces_(pieces),
        visit_(visit) {}

  [[nodiscard]] Status run(const Goal& goal) {
    Result<DomainTriangulation> domain = triangulate_domain(pslg_, convex_hull_, threads_);
    if (!domain) return domain.error();
    Report report;
    report.triangulate_seconds = watch_.lap();
    InputData input = input_data(pslg_, *domain, threads_);
    report.gaps = gaps_in_ranks(*domain, ranks_, threads_);
    const Result<RunPlan> plan = plan_run(pslg_, goal, *domain, options_, threads_);
    if (!plan) return plan.error();
    if (outgrows_memory(pslg_.points.size(), options_)) return too_much_memory(options_);
    if (!plan->edges_of_patches.empty()) return fill(std::move(*domain), *plan, std::move(input), std::move(report));
    if (pieces_ > ranks_.count())
      return Error{ErrorKind::usage,
                   "more pieces than ranks are for interiors of equilateral triangles only, which need constant bounds "
                   "on areas or edges"};
    Result<MeshPiece> piece = refine(*domain, plan->criteria, std::move(input), std::move(report));
    if (!piece) return piece.error();
    return visit_(std::move(*piece), ranks_.rank());
  }

 private:
  /// The piece of this rank, by refinement of the whole domain.
  [[nodiscard]] Result<MeshPiece> refine(DomainTriangulation& domain, const Criteria& criteria, InputData input,
                                         Report report) {
    Distribution distribution(ranks_, domain.triangulation, domain.input_of_vertex.span(), input.points.markers);
    return refine_in_ranks(domain, distribution, criteria, options_, progress_, std::move(input), std::move(report),
                           watch_);
  }

  /// As refine_filled().
  [[nodiscard]] Status fill(DomainTriangulation domain, const RunPlan& plan, InputData input, Report report) {
    const ToFill what{pslg_, convex_hull_, plan.edges_of_patches, static_cast<std::uint64_t>(pieces_)};
    Result<std::optional<FilledRound>> round =
        successful_round(what, domain, plan.criteria, input, options_, progress_, report);
    if (!round) return round.error();
    if (!round->has_value()) {
      Result<MeshPiece> piece = refine(domain, plan.criteria, std::move(input), std::move(report));
      if (!piece) return piece.error();
      return visit_refined(std::move(*piece));
    }
    FilledRound& with_patches = **round;
    const Report before = report;
    with_patches.write_report(threads_, report);
    const Candidate filled{report.goal_met(), with_patches.triangles()};
    const std::uint64_t twice_the_vertices = filled.triangles / static_cast<std::uint64_t>(ranks_.count());
    if (may_be_worse(filled, with_patches.laid()) && !outgrows_memory(twice_the_vertices, options_)) {
      Result<MeshPiece> refined = refine(domain, plan.criteria, input, before);
      if (!refined) return refined.error();
      if (is_better({refined->missed == 0, refined->triangles}, filled)) return visit_refined(std::move(*refined));
    }
    domain = {};
    Result<FilledPieces> all = FilledPieces::make(std::move(with_patches), std::move(input), std::move(report),
                                                  static_cast<std::size_t>(pieces_), threads_);
    if (!all) return all.error();
    check_alike(all->around(), ranks_);
    return visit_filled(*all);
  }

  [[nodiscard]] Status visit_filled(const FilledPieces& all) {
    const double refine_seconds = watch_.lap();
    for (int number = ranks_.rank(); number < pieces_; number += ranks_.count()) {
      watch_.lap();
      MeshPiece piece = all.piece(static_cast<std::size_t>(number), threads_);
      piece.report.refine_seconds = refine_seconds;
      piece.seconds = watch_.lap();
      if (Status visited = visit_(std::move(piece), number); !visited) return visited;
    }
    return Done{};
  }

  /// The piece of this rank, and empty ones.
  [[nodiscard]] Status visit_refined(MeshPiece&& piece) {
    MeshPiece empty;
    empty.mesh.region_attributes = piece.mesh.region_attributes;
    empty.mesh.attributes_per_point = piece.mesh.attributes_per_point;
    empty.first_triangle = empty.triangles = piece.triangles;
    empty.first_point = empty.points = piece.points;
    empty.constrained_edges = piece.constrained_edges;
    empty.missed = piece.missed;
    empty.report = piece.report;
    empty.report.exempt.clear();
    if (Status visited = visit_(std::move(piece), ranks_.rank()); !visited) return visited;
    for (int number = ranks_.rank() + ranks_.count(); number < pieces_; number += ranks_.count())
      if (Status visited = visit_(MeshPiece(empty), number); !visited) return visited;
    return Done{};
  }

  const Pslg& pslg_;
  bool convex_hull_;
  const Options& options_;
  ProgressMonitor& progress_;
  Threads threads_;
  Ranks& ranks_;
  int pieces_;
  const VisitPiece& visit_;
  Stopwatch watch_;
};

}  // namespace

Status mesh_in_ranks(const Pslg& pslg, bool convex_hull, const Goal& goal, const Options& options,
                     ProgressMonitor& progress, Ranks& ranks, int pieces, const VisitPiece& visit) {
  return RunInRanks(pslg, convex_hull, options, progress, ranks, pieces, visit).run(goal);
}

}  // namespace pardel::engine
