// The refinement of a domain by several ranks, and the piece of this rank.
#pragma once

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "../../core/support/exchange_lists.hpp"
#include "../../core/support/stopwatch.hpp"
#include "../refinement/exemptions.hpp"
#include "../scheduling/refine_by_sweeps.hpp"
#include "../triangulation/flips.hpp"
#include "piece.hpp"

namespace pardel::engine {

/// Which of the sides, whose far sides this rank does not hold, are not Delaunay? The owner of an end of a side has
/// both of its triangles. Returns the sides that are not. Collective.
[[nodiscard]] inline std::vector<EdgeRef> non_delaunay_of(const std::vector<EdgeRef>& sides, const Triangulation& t,
                                                          const Distribution& distribution) {
  struct Question {
    Name triangle;
    std::uint64_t side;
  };
  Ranks& ranks = distribution.network();
  std::vector<std::vector<Question>> questions(static_cast<std::size_t>(ranks.count()));
  std::vector<std::vector<EdgeRef>> asked(questions.size());
  for (const EdgeRef e : sides) {
    const int rank = distribution.owner_of(t.slot(e).from(e.side()));
    questions[rank].push_back({distribution.part().name_of(e.triangle()), e.side()});
    asked[rank].push_back(e);
  }
  std::vector<std::vector<char>> answers;
  for (const std::vector<Question>& list : exchange_lists(questions, ranks)) {
    std::vector<char>& answer = answers.emplace_back();
    for (const Question& q : list) {
      const TriangleId id = distribution.part().triangle(q.triangle);
      if (id == no_index || q.side > 2) throw Reader::does_not_match();
      answer.push_back(delaunay_across(t, EdgeRef(id, static_cast<unsigned>(q.side))) ? 1 : 0);
    }
  }
  std::vector<EdgeRef> found;
  const auto arrived = exchange_lists(answers, ranks);
  for (std::size_t rank = 0; rank < asked.size(); ++rank)
    for (std::size_t i = 0; i < asked[rank].size(); ++i)
      if (arrived[rank].at(i) == 0) found.push_back(asked[rank][i]);
  return found;
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
  std::vector<EdgeRef> undecided;
  write_report(
      domain, criteria, options, std::move(*counts), progress.threads(), report,
      [&](TriangleId id) { return distribution.part().has(id) && distribution.owner_of_triangle(id) == ranks.rank(); },
      &undecided);
  if (criteria.conforming()) {  // for other goals, all is decided
    std::set<TriangleId> listed;
    for (const EdgeRef e : non_delaunay_of(undecided, domain.triangulation, distribution))
      if (listed.insert(e.triangle()).second)
        report.exempt.push_back(
            {e.triangle(), why_not_split(domain.triangulation, domain.segments, criteria, options, e)});
  }
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
