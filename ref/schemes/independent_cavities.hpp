// Independent cavities: in each round, a maximal set of insertions that do not disturb each other.
//
// Source: H. Edelsbrunner, D. Guoy, "Sink-insertion for mesh improvement", 2001, section 6 (insertion in parallel): two
// points are independent if the closures of their prestars (here: cavities) are disjoint. A maximal independent set of
// all circumcentres of bad triangles is inserted, and the rest waits for the next round. [CC] says that this needs all
// cavities before the first insertion: `Account::work` counts them all, `Account::wasted` those that were not chosen.
//
// Choices that the paper leaves open:
// - the maximal set: greedy, in an order drawn at random in each round (the parallel depth of this order is small:
//   Blelloch, Fineman and Shun, "Greedy sequential maximal independent set and matching are parallel on average",
//   2012);
// - encroached subsegments compete with their midpoints, in the same rounds.
//
// Where an implementer goes wrong: cavities that share only a vertex or an edge conflict by the closures, although no
// triangle is common; the ring around a cavity does not belong to its closure.
#pragma once

#include "rounds/in_rounds.hpp"

namespace pardel::schemes {

/// When two insertions may be carried out in one round.
enum class Independence : std::uint8_t {
  closures,  ///< Edelsbrunner and Guoy: the cavities have no vertex in common (THEORY.md, T1-closures)
  exact,     ///< exactly when they do not disturb each other (THEORY.md, T1-iff)
};

/// May both be carried out at once? Precondition: both were found in this mesh.
[[nodiscard]] bool are_independent(const LinkedMesh& mesh, const Insertion& p, const Insertion& q, Independence when);

/// A maximal set of pairwise independent candidates, greedily in the order of their priorities. Linear time in the
/// sizes of the cavities.
[[nodiscard]] Chosen independent_set(const LinkedMesh& mesh, const std::vector<Candidate>& candidates,
                                     Independence when);

[[nodiscard]] Result<Outcome> independent_cavities(const Problem& problem, Independence when = Independence::closures);
/// The rules of its rounds, for tests.
[[nodiscard]] RoundRules rules_of_independent_cavities(Independence when);

}  // namespace pardel::schemes
