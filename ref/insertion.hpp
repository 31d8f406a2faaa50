// Insertion of a point into a (constrained) Delaunay mesh by the algorithm of Bowyer and Watson, which [CC] uses: find
// the cavity, delete its triangles, and connect the point to the boundary of the cavity.
#pragma once

#include <optional>
#include <vector>

#include "definitions.hpp"

namespace pardel::ref {

/// The boundary of a set of triangles: the edges that belong to exactly one triangle of the set. Each edge is directed,
/// with the set on its left.
[[nodiscard]] std::vector<Edge> boundary(const PlainMesh& mesh, const std::vector<Index>& triangles);

/// The fan of p: one triangle (a, b, p) for each edge ab of the boundary of the cavity. `vertex` is the index of p. An
/// edge that contains p is skipped: it is a border edge, which p splits.
[[nodiscard]] std::vector<Corners> retriangulation(const PlainMesh& mesh, const std::vector<Index>& cavity,
                                                   Index vertex);

/// The constrained edge that contains p in its interior, if there is one.
[[nodiscard]] std::optional<Edge> constraint_through(const PlainMesh& mesh, const ExactPoint& p);

/// Replaces the constrained edge e by the two edges from its ends to `vertex`.
void split_constraint(PlainMesh& mesh, const Edge& e, Index vertex);

/// Appends p, inserts it and returns its index. Precondition: p lies in the mesh and is not a vertex. A constrained
/// edge that contains p is split in two.
Index insert(PlainMesh& mesh, const ExactPoint& p);

/// The Delaunay triangulation of the points and of the corners (±half_width, ±half_width) of a box that contains them,
/// built by inserting one point after the other. The corners are the last four points of the mesh. Precondition: the
/// points are distinct.
[[nodiscard]] PlainMesh delaunay_in_box(const std::vector<Point>& points, double half_width);

/// As delaunay_in_box(), with a box so large that its corners lie outside the diametral circle of every two points.
[[nodiscard]] PlainMesh delaunay_in_far_box(const std::vector<Point>& points);

}  // namespace pardel::ref
