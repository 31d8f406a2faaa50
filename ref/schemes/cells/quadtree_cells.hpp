// The leaves of a quadtree as cells of a graded mesh.
//
// Sources: A. N. Chernikov, N. P. Chrisochoides, "Generalized Delaunay mesh refinement: from scalar to parallel", 2006,
// as we recall it (leaves, buffer zones, the condition on circumradii); properties/THEORY.md, Quadtree (balance).
#pragma once

#include "../rules/ruppert.hpp"
#include "division.hpp"

namespace pardel::schemes::cells {

/// The expected number of triangles in the place of t: its area divided by the wanted area there, at least 1.
[[nodiscard]] double expected_triangles(const LinkedMesh& mesh, Index t, const Bounds& bounds);

/// The leaves of the quadtree over a mesh. A square is divided if this leaves the tree balanced (the sides of leaves
/// that touch differ at most by a factor of two), if each circumdisk that meets one of its quarters has a radius below
/// `fraction` of the quarter's side, and if more than the `wanted`-th part of all triangles is expected in it or in a
/// square of its size beside it. The cells `touching` a leaf are those of its buffer zone; none of them has its colour.
/// Boxes have a margin of half a side. A circumdisk is allowed if it is small enough for all leaves that it meets. O(n
/// log n) time for n triangles.
[[nodiscard]] Division quadtree_cells(const LinkedMesh& mesh, const Bounds& bounds, double wanted, double fraction,
                                      Assignment assignment, const Territory& territory);

}  // namespace pardel::schemes::cells
