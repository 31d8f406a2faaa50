// Edge flips: how segments are forced into a Delaunay triangulation, and how an insertion that the cavity
// cannot express (see insert.hpp) is finished.
#pragma once

#include <vector>

#include "triangulation.hpp"

namespace pardel::engine {

/// Replaces the diagonal of the quadrilateral around the unconstrained edge e by the other one.
/// Precondition: both sides are triangles and the quadrilateral is strictly convex. Afterwards the new
/// diagonal is side 1 of e.triangle() and side 1 of the triangle across.
void flip(Triangulation& t, EdgeRef e);

/// The edge is constrained, or the corner across lies not strictly inside the circumcircle.
[[nodiscard]] bool locally_delaunay(const Triangulation& t, EdgeRef e);

/// The same, constrained or not. Precondition: there is a triangle across.
[[nodiscard]] bool delaunay_across(const Triangulation& t, EdgeRef e);

/// Flips until every edge that is not constrained and can be reached from `suspects` by flips is locally
/// Delaunay (Lawson 1977). Appends every triangle that a flip changed to `changed`, perhaps repeatedly.
void restore_delaunay(Triangulation& t, std::vector<EdgeRef> suspects, std::vector<TriangleId>& changed);

}  // namespace pardel::engine
