// The refinement of a domain by several ranks, and the piece of this rank.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "../../core/support/exchange_lists.hpp"
#include "../../core/support/stopwatch.hpp"
#include "../scheduling/refine_by_sweeps.hpp"
#include "piece.hpp"

namespace pardel::engine {

/// Of a triangle with segments as sides: a corner at which all of them end, if there is one. The owner of this corner
/// has the triangles on the other sides of the segments.
[[nodiscard]] inline VertexId corner_of_segments(const Slot& slot) {
  for (unsigned i = 0; i < 3; ++i)
    if (!slot.n[i].constrained()) return slot.v[i];
  return slot.v[0];
}

/// A rank may not have the triangle beyond a segment, and then does not know whether a triangle of its piece breaks the
/// goal. It asks a rank that has. Adds the answers to report.exempt. Collective.
inline void decide(const std::vector<TriangleId>& undecided, DomainTriangulation& domain,
                   const Distribution& distribution, const Criteria& criteria, const Options& options,
                   const Threads& threads, Report& report) {
  struct Answer {
    std::uint64_t breaks_goal = 0;
    Exemption exemption{};
  };
  Ranks& ranks = distribution.network();
  const Triangulation& t = domain.triangulation;
  std::vector<std::vector<Name>> names(static_cast<std::size_t>(ranks.count()));
  std::vector<std::vector<TriangleId>> asked(names.size());
  for (const TriangleId id : undecided) {
    const int rank = distribution.owner_of(corner_of_segments(t.slots[id]));
    names[rank].push_back(distribution.part().name_of(id));
    asked[rank].push_back(id);
  }
  const auto questions = exchange_lists(names, ranks);
  std::vector<TriangleId> here;
  for (const Name name : concatenated(questions)) here.push_back(distribution.part().triangle(name));
  std::ranges::sort(here);
  RefineCounts only_these;
  only_these.left_alone = !here.empty();
  Report found;
  write_report(domain, criteria, options, std::move(only_these), threads, found,
               [&](TriangleId id) { return std::ranges::binary_search(here, id); });
  std::vector<std::vector<Answer>> answers(names.size());
  for (std::size_t rank = 0; rank < answers.size(); ++rank)
    for (const Name name : questions[rank]) {
      const auto at = std::ranges::find(found.exempt, distribution.part().triangle(name), &Exemption::triangle);
      answers[rank].push_back(at != found.exempt.end() ? Answer{1, *at} : Answer{});
    }
  const auto arrived = exchange_lists(answers, ranks);
  for (std::size_t rank = 0; rank < asked.size(); ++rank)
    for (std::size_t i = 0; i < asked[rank].size(); ++i)
      if (arrived[rank].at(i).breaks_goal != 0) {
        report.exempt.push_back(arrived[rank][i].exemption);
        report.exempt.back().triangle = asked[rank][i];
      }
}

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
  std::vector<TriangleId> undecided;
  write_report(
      domain, criteria, options, std::move(*counts), progress.threads(), report,
      [&](TriangleId id) { return distribution.part().has(id) && distribution.owner_of_triangle(id) == ranks.rank(); },
      &undecided);
  decide(undecided, domain, distribution, criteria, options, progress.threads(), report);
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
