// Edge flips. They insert constraints into a Delaunay triangulation (construction/insert_constraints.hpp). They also
// complete insertions of points whose cavity cannot be replaced by a fan (refinement/insertion.hpp).
#pragma once

#include <vector>

#include "../threads/threads.hpp"
#include "triangulation.hpp"

namespace pardel::engine {

/// Replaces the unconstrained edge e, the diagonal of a quadrilateral, by the other diagonal. Preconditions: e has a
/// triangle on each side, and the quadrilateral is strictly convex. Afterwards the new diagonal is side 1 of
/// e.triangle() and side 1 of the triangle across.
void flip(Triangulation& t, EdgeRef e);

/// True if the edge is constrained or delaunay_across(t, e).
[[nodiscard]] bool locally_delaunay(const Triangulation& t, EdgeRef e);

/// True if the apex across the edge does not lie strictly inside the circumcircle of e.triangle(). Ignores constraints.
/// Precondition: there is a triangle across.
[[nodiscard]] bool delaunay_across(const Triangulation& t, EdgeRef e);

/// Flips `suspects`, and the edges around each flip, until all unconstrained ones are locally Delaunay (Lawson 1977).
/// Appends every triangle that a flip changed to `changed`, possibly several times. Runs on
/// one thread.
void restore_delaunay(Triangulation& t, std::vector<EdgeRef> suspects, std::vector<TriangleId>& changed,
                      const Threads& threads = {});

/// Flips edges until the whole triangulation is constrained Delaunay. O(n) for n triangles, and the flips.
void make_delaunay(Triangulation& t, const Threads& threads = {});

}  // namespace pardel::engine
