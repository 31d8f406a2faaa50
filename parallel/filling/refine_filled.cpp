#include "refine_filled.hpp"

#include <utility>

#include "../triangulation/limits.hpp"

namespace pardel::engine {

Result<Mesh> refine_filled(const ToFill& what, DomainTriangulation domain, const Criteria& criteria,
                           const InputData& input, const Options& options, ProgressMonitor& progress, Report& report) {
  Result<std::optional<FilledRound>> round = successful_round(what, domain, criteria, input, options, progress, report);
  if (!round) return round.error();
  if (!round->has_value()) return refine_domain(std::move(domain), criteria, input, options, progress, report);
  Report without_patches = report;
  FilledRound& with_patches = **round;
  with_patches.write_report(progress.threads(), report);
  const Candidate filled{report.goal_met(), with_patches.triangles()};
  const std::uint64_t twice_the_vertices = filled.triangles;
  if (may_be_worse(filled, with_patches.laid()) && !outgrows_memory(twice_the_vertices, options)) {
    Result<Mesh> refined = refine_domain(std::move(domain), criteria, input, options, progress, without_patches);
    if (!refined) return refined;
    if (is_better({without_patches.goal_met(), refined->triangles.size()}, filled)) {
      report = std::move(without_patches);
      return refined;
    }
  }
  return with_patches.take_mesh(input, progress.threads());
}

}  // namespace pardel::engine
