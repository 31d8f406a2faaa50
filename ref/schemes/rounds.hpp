// Rounds of independent points: in each round, a maximal set of centres that lie apart.
//
// Source: D. A. Spielman, S.-H. Teng, A. Üngör, "Parallel Delaunay refinement: algorithms and analyses", 2002 and 2007.
// Section 3: two centres conflict if each lies inside the disk of the other, that is, if their distance is below the
// smaller of their radii. A maximal set without conflicts is inserted in each round. Inserted one after the other, the
// largest disk first, each disk is still empty when its turn comes: so one worker could have made the same mesh.
//
// The same authors, "Time complexity of practical parallel Steiner point insertion algorithms", 2004: all bad triangles
// take part in each round.
//
// Cavities of one round may overlap. The papers leave the update of the triangulation to a parallel Delaunay algorithm.
// Here, an insertion whose cavity has been changed in its round finds it again: this is counted as work.
//
// Choices that the papers leave open:
// - which centres take part in a round: all, or only those whose disks are nearly as large as the largest one, class by
//   class, as the proof of O(log² (L/s)) rounds goes (`Batch`);
// - the maximal set: greedy, in an order drawn at random in each round, or the largest disk first (`Priority`).
//
// Where an implementer goes wrong: midpoints of encroached subsegments compete, too, with the radius of the half; a
// centre that is rejected because it encroaches counts with the midpoint that takes its place.
#pragma once

#include "rounds/in_rounds.hpp"

namespace pardel::schemes {

enum class Batch : std::uint8_t { all, largest_class };
enum class Priority : std::uint8_t { random, largest_first };

struct RoundChoices {
  Batch batch = Batch::all;
  Priority priority = Priority::random;
};

/// The square of the radius of an insertion's disk. For a circumcentre it is the circumdisk. For a point that splits a
/// side, it is the disk around the point that reaches to the nearer end of the side.
[[nodiscard]] double squared_radius(const LinkedMesh& mesh, const Insertion& insertion);

/// Is the distance of the points below the smaller of the radii?
[[nodiscard]] bool conflict(const LinkedMesh& mesh, const Insertion& p, const Insertion& q);

/// A maximal set of candidates, the largest disk first, of which no two conflict that have a triangle of their cavities
/// in common. For circumcentres this finds all conflicts: if each of two lies in the disk of the other, both bad
/// triangles belong to both cavities, unless a segment lies between them, and then neither disturbs the other.
[[nodiscard]] Chosen centres_apart(const LinkedMesh& mesh, const std::vector<Candidate>& candidates,
                                   const RoundChoices& choices);

[[nodiscard]] Result<Outcome> rounds(const Problem& problem, const RoundChoices& choices = {});
/// The rules of its rounds, for tests.
[[nodiscard]] RoundRules rules_of_rounds(const RoundChoices& choices);

}  // namespace pardel::schemes
