// Sink insertion: from each bad triangle, walk towards the largest empty disk nearby, and insert its centre.
//
// Source: H. Edelsbrunner, D. Guoy, "Sink-insertion for mesh improvement", 2001. Section 3: a triangle that does not
// contain its circumcentre flows to the neighbour behind the side that separates them; a triangle that contains it is a
// sink. Section 6: sinks are inserted in parallel, a maximal set with disjoint closures of cavities in each round.
//
// The paper is about triangulations without segments. Here, a walk that meets a segment ends there, and the segment is
// split; a sink whose circumcentre encroaches upon a segment splits the segment (Ruppert).
//
// Where an implementer goes wrong: the circumcentre of a right triangle lies on its longest side. It does not flow, or
// two right triangles with a common longest side would flow to each other for ever. And the circumcentre must not be
// rounded before it is compared with a side: what decides is whether the angle opposite to the side is obtuse.
#pragma once

#include "independent_cavities.hpp"

namespace pardel::schemes {

/// The side behind which the circumcentre of t lies: that opposite to an obtuse angle. Nothing if t is a sink: if it
/// contains its circumcentre in its interior or on its border. Exact.
[[nodiscard]] std::optional<Side> flow(const LinkedMesh& mesh, Index t);

/// The triangles from t on to the sink, or to the triangle whose flow a segment or the border stops.
[[nodiscard]] std::vector<Index> walk_to_sink(const LinkedMesh& mesh, Index t);

/// What sink insertion does for a triangle that needs work: it splits an encroached side, inserts the circumcentre of
/// the sink, or splits the segment that stopped the walk. Adds the triangles of the walk to `read`.
[[nodiscard]] std::optional<Insertion> sink_insertion(const LinkedMesh& mesh, Index t, const Bounds& bounds,
                                                      std::uint64_t& read);

/// Refines by sinks in rounds. `when`: which sinks are inserted in the same round.
[[nodiscard]] Result<Outcome> sinks(const Problem& problem, Independence when = Independence::closures);
/// The rules of its rounds, for tests.
[[nodiscard]] RoundRules rules_of_sinks(Independence when);

}  // namespace pardel::schemes
