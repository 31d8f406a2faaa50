// Constrained Delaunay triangulation by flips: first every segment is made an edge, then every unconstrained edge that
// is not locally Delaunay is flipped.
//
// Sources: C. L. Lawson, "Software for C1 surface interpolation", 1977 (flips end in the Delaunay triangulation);
// S. W. Sloan, "A fast algorithm for generating constrained Delaunay triangulations", 1993 (forcing an edge).
#pragma once

#include <vector>

#include "definitions.hpp"

namespace pardel::ref {

/// The Delaunay triangulation of the convex hull of the points. Preconditions: the points are distinct, do not all lie
/// on one line, and their coordinates are multiples of 2^-50 of absolute value at most 2^50. Cubic time. The edges of
/// the hull are not constrained.
[[nodiscard]] PlainMesh delaunay(const std::vector<Point>& points);

/// Flips the edges that cross ab until ab is an edge, and constrains it. Precondition: the open segment ab contains no
/// vertex and crosses no constrained edge. Afterwards the mesh need not be constrained Delaunay.
void force_edge(PlainMesh& mesh, Index a, Index b);

/// Flips unconstrained edges until every one is locally Delaunay. Then the mesh is constrained Delaunay.
void flip_to_delaunay(PlainMesh& mesh);

/// The constrained Delaunay triangulation of the convex hull of the points. Preconditions: as for delaunay(); two
/// walls meet only in common ends, and no point lies inside a wall.
[[nodiscard]] PlainMesh constrained_delaunay(const std::vector<Point>& points, const std::vector<Edge>& walls);

}  // namespace pardel::ref
