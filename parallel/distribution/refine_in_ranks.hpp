// The refinement of a domain by several ranks, and the piece of this rank.
#pragma once

#include <algorithm>
#include <utility>

#include "../../core/support/stopwatch.hpp"
#include "../scheduling/refine_by_sweeps.hpp"
#include "piece.hpp"

namespace pardel::engine {

/// Refines the domain of the distribution's triangulation, and makes the piece of this rank. Collective. `watch`: since
/// the last step.
[[nodiscard]] inline Result<MeshPiece> refine_in_ranks(DomainTriangulation& domain, Distribution& distribution,
                                                       const Criteria& criteria, const Options& options,
                                                       ProgressMonitor& progress, InputData input, Report report,
                                                       Stopwatch& watch) {
  Ranks& ranks = distribution.network();
  Result<RefineCounts> counts =
      refine_by_sweeps(domain.triangulation, domain.segments, criteria, options, progress, {}, {}, &distribution);
  if (!counts) return counts.error();
  report.refine_seconds = watch.lap();
  write_report(domain, criteria, options, std::move(*counts), progress.threads(), report, [&](TriangleId id) {
    return distribution.part().has(id) && distribution.owner_of_triangle(id) == ranks.rank();
  });
  MeshPiece piece = make_piece(domain, distribution, std::move(input), report.exempt, progress.threads());
  std::ranges::sort(report.exempt, {}, &Exemption::triangle);
  const auto missed = std::ranges::count_if(report.exempt, [](const Exemption& e) { return !justified(e.reason); });
  piece.missed = static_cast<std::uint64_t>(missed);
  ranks.add_up({&piece.missed, 1});
  piece.seconds = watch.lap();
  piece.report = std::move(report);
  return piece;
}

}  // namespace pardel::engine
