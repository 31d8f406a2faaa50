// The refinement of a domain by several ranks, and the piece of this rank.
#pragma once

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "../../core/support/answers_of_ranks.hpp"
#include "../../core/support/stopwatch.hpp"
#include "../../parallel/refinement/exemptions.hpp"
#include "../../parallel/scheduling/refine_by_sweeps.hpp"
#include "../../parallel/triangulation/flips.hpp"
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
  std::vector<Question> questions;
  questions.reserve(sides.size());
  for (const EdgeRef e : sides) questions.push_back({distribution.part().name_of(e.triangle()), e.side()});
  const auto whom = [&](std::size_t i) { return distribution.owner_of(t.slot(sides[i]).from(sides[i].side())); };
  const auto answer = [&](const std::vector<Question>& asked) {
    std::vector<char> are_delaunay;
    for (const Question& q : asked) {
      const TriangleId id = distribution.part().triangle(q.triangle);
      if (id == no_index || q.side > 2) throw Reader::does_not_match();
      are_delaunay.push_back(delaunay_across(t, EdgeRef(id, static_cast<unsigned>(q.side))) ? 1 : 0);
    }
    return are_delaunay;
  };
  const std::vector<char> are_delaunay = answers_of_ranks<char>(questions, 1, distribution.network(), whom, answer);
  std::vector<EdgeRef> found;
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (are_delaunay[i] == 0) found.push_back(sides[i]);
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
      refine_by_sweeps(domain.triangulation, domain.segments, criteria, options, progress, {}, {}, distribution);
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
  if (criteria.has_user_test()) ranks.add_up({&report.fail_user_test, 1});
  piece.seconds = watch.lap();
  piece.report = std::move(report);
  return piece;
}

}  // namespace pardel::engine
