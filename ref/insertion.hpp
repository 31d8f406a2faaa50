// Inserting a point into a (constrained) Delaunay mesh by the Bowyer-Watson kernel, the one that [CC] builds on:
// find the cavity, delete its triangles, and connect the point to the cavity's boundary.
#pragma once

#include <optional>
#include <vector>

#include "definitions.hpp"

namespace pardel::ref {

/// The boundary of a set of triangles: the edges of exactly one of them, each as a directed pair that has
/// the set on its left.
[[nodiscard]] std::vector<Edge> boundary(const PlainMesh& mesh, const std::vector<Index>& triangles);

/// What insertion makes of the cavity: one triangle (a, b, p) per boundary edge ab, `vertex` being p's
/// index. An edge that p lies on is skipped: p splits an edge of the hull there.
[[nodiscard]] std::vector<Corners> retriangulation(const PlainMesh& mesh, const std::vector<Index>& cavity,
                                                   Index vertex);

/// The constrained edge that p lies on, other than at an end.
[[nodiscard]] std::optional<Edge> constraint_through(const PlainMesh& mesh, const ExactPoint& p);

/// Replaces the constrained edge e by its halves, from its ends to the vertex.
void split_constraint(PlainMesh& mesh, const Edge& e, Index vertex);

/// Appends p and inserts it; returns its index. p must lie in the mesh and be none of its vertices. A
/// constrained edge that p lies on is split in two.
Index insert(PlainMesh& mesh, const ExactPoint& p);

/// The Delaunay triangulation of the points (all distinct, not all on a line) within a far box whose four
/// corners are the last four points: sequential insertion, one after the other.
[[nodiscard]] PlainMesh delaunay_in_far_box(const std::vector<Point>& points);

}  // namespace pardel::ref
