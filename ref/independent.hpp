// Several points at once: what concurrent insertion does, and when it may be done.
#pragma once

#include <vector>

#include "definitions.hpp"

namespace pardel::ref {

/// Independent insertion [CC]: every cavity is found in M and retriangulated against M, as by tasks that
/// know nothing of each other, and the results are united. The points lie in the mesh and are none of its vertices;
/// a constrained edge that one lies on is split there, at most one point on each. Where the points are not independent
/// the outcome is no mesh; it is returned as it is. The points are appended in order.
[[nodiscard]] PlainMesh insert_independently(const PlainMesh& mesh, const std::vector<ExactPoint>& points);

/// The triangles as a set that depends neither on their order nor on the numbers of vertices: the corners
/// of each, the least first, in counter-clockwise order.
[[nodiscard]] std::set<std::array<ExactPoint, 3>> triangles_as_points(const PlainMesh& mesh);

/// No vertex is common to the closures of the two cavities in M; then p and q are independent (Edelsbrunner
/// and Guoy).
[[nodiscard]] bool closures_are_disjoint(const PlainMesh& mesh, const ExactPoint& p, const ExactPoint& q);

/// Exactly when p and q may be inserted independently: the cavities have no triangle in common, and for every
/// edge mn on the boundaries of both, p is not inside the circumcircle of q, m and n (which then q is not for p, m
/// and n). A constrained mn needs no such test, as neither point sees past it. Both points lie in the mesh and are
/// distinct and none of its vertices. Not in [CC], which uses sufficient conditions only.
[[nodiscard]] bool are_independent(const PlainMesh& mesh, const ExactPoint& p, const ExactPoint& q);

}  // namespace pardel::ref
