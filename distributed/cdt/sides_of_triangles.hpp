// The segments that are edges of the triangulation. Only the ranks at such an edge know them.
#pragma once

#include <span>
#include <vector>

#include "../../core/ranks.hpp"
#include "../delaunay/local_delaunay.hpp"
#include "../delaunay/own_points.hpp"
#include "given_segment.hpp"

namespace pardel::engine {

/// The edge from a to b, as a side of the triangle on its left. none() if the triangulation of this rank has no such
/// edge. Precondition: the rank knows point a.
[[nodiscard]] EdgeRef side_between(LocalDelaunay& delaunay, const Site& a, const Site& b);

/// Collective. Tells other ranks about the segments that are sides of their triangles, but do not end at their points.
/// They get the triangles on both sides of such a segment. Returns the segments of this rank, and those of which other
/// ranks told it. `own_segments`: those that end at own points. Precondition: all of them are edges, and have triangles
/// on both sides.
[[nodiscard]] std::vector<Constraint> learn_sides(std::span<const GivenSegment> own_segments, LocalDelaunay& delaunay,
                                                  const OwnPoints& own, Ranks& ranks);

/// Marks the edges as constrained.
void constrain(std::span<const Constraint> edges, LocalDelaunay& delaunay);

}  // namespace pardel::engine
