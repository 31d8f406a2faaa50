// Refinement in rounds: what the schemes with independent points have in common. In each round every triangle that
// needs work names an insertion, some of them are chosen, and all chosen ones are carried out at once.
#pragma once

#include <functional>

#include "../workers/problem.hpp"

namespace pardel::schemes {

/// An insertion that a triangle asks for in this round. Several triangles may ask for one point.
struct Candidate {
  Insertion insertion;
  std::uint64_t priority = 0;  ///< drawn at random: a hash of the seed, the round and the place in the list
};

/// The candidates that are carried out, in the order in which one worker could insert them one after the other.
struct Chosen {
  std::vector<std::size_t> candidates;  ///< indices
  /// The longest chain of decisions of which each waits for the one before it. The workers synchronise so often.
  std::uint64_t depth = 1;
};

struct RoundRules {
  /// The insertion that a triangle asks for, for example insertion_for(). Adds to the last argument what was read
  /// beside the cavity.
  std::function<std::optional<Insertion>(const LinkedMesh&, Index, const Bounds&, std::uint64_t&)> propose;
  /// Chooses among the candidates, at least one. Each is compared with what its cavity touches: as much work as the
  /// cavity has triangles.
  std::function<Chosen(const LinkedMesh&, const std::vector<Candidate>&)> choose;
  /// Called before the chosen insertions of a round are carried out; for tests.
  std::function<void(const LinkedMesh&, const std::vector<Candidate>&, const Chosen&)> watch{};
};

/// Refines until no triangle asks for an insertion. If an earlier insertion of the round has changed the cavity of a
/// chosen one, it is found again; if its triangle is gone, it is a set-back. The worker that owns a point works for it.
/// Workers read the triangles of others at the start of a round, and write them at its end: one message per pair and
/// direction. `Account::rounds` counts rounds. The mesh does not depend on the number of workers. Errors: those of
/// start_of() and too_many_points().
[[nodiscard]] Result<Outcome> refine_in_rounds(const Problem& problem, const RoundRules& rules);

/// The same for several numbers of workers at once, which make one mesh: one account for each.
struct SharedOutcome {
  LinkedMesh mesh;
  std::vector<Account> accounts;
};
[[nodiscard]] Result<SharedOutcome> refine_in_rounds(const Problem& problem, const RoundRules& rules,
                                                     const std::vector<int>& workers);

/// Indices of the candidates in the order of their priorities.
[[nodiscard]] std::vector<std::size_t> by_priority(const std::vector<Candidate>& candidates);

}  // namespace pardel::schemes
