// Independent insertion: inserting several points into one mesh at the same time, and the condition that makes it
// correct.
#pragma once

#include <vector>

#include "definitions.hpp"

namespace pardel::ref {

/// Independent insertion [CC]: finds every cavity in `mesh` and builds every fan from `mesh`, like tasks that do not
/// communicate, and unites the results. A constrained edge is split at a point that lies on it. The points are appended
/// in order. If they are not independent, triangles of the result may overlap or not be Delaunay; no error is reported.
/// Points 2 r̄ apart are independent (THEORY.md, T1-sharp), and at 4 r̄ no triangle is touched by two insertions (T1).
/// Preconditions: the points lie in the mesh and are not vertices; at most one of them lies on each constrained edge.
[[nodiscard]] PlainMesh insert_independently(const PlainMesh& mesh, const std::vector<ExactPoint>& points);

/// The triangles as a set that depends neither on their order nor on the numbering of vertices. Each entry has the
/// corners of one triangle, counter-clockwise; the lexicographically least corner comes first.
[[nodiscard]] std::set<std::array<ExactPoint, 3>> triangles_as_points(const PlainMesh& mesh);

/// Do the closures of the two cavities have no vertex in common? Then p and q are independent (Edelsbrunner and Guoy;
/// THEORY.md, T1-closures).
[[nodiscard]] bool closures_are_disjoint(const PlainMesh& mesh, const ExactPoint& p, const ExactPoint& q);

/// Are p and q independent? The condition is exact (THEORY.md, T1-iff): the cavities have no triangle in common, and
/// for every unconstrained edge mn on both boundaries, p is not inside the circumcircle of q, m and n. The condition is
/// symmetric. Constrained edges are not tested, because neither point sees across them. Preconditions: p and q are
/// distinct, lie in the mesh and are not vertices. [CC] gives only sufficient conditions.
[[nodiscard]] bool are_independent(const PlainMesh& mesh, const ExactPoint& p, const ExactPoint& q);

}  // namespace pardel::ref
