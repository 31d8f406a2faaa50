// Constrained Delaunay triangulation, by flips: force the segments, then flip what is not locally Delaunay.
//
// Sources: C. L. Lawson, "Software for C1 surface interpolation", 1977 (flips end in the Delaunay triangulation);
// S. W. Sloan, "A fast algorithm for generating constrained Delaunay triangulations", 1993 (forcing an edge).
#pragma once

#include <vector>

#include "definitions.hpp"

namespace pardel::ref {

/// The Delaunay triangulation of the convex hull of the points: distinct, not all on a line, multiples of 2^-50 of
/// at most 2^50. Cubic time. The hull's edges are no constraints.
[[nodiscard]] PlainMesh delaunay(const std::vector<Point>& points);

/// Makes ab an edge by flipping those that cross it, and constrains it. It must run through no vertex and cross no
/// constraint. The mesh is in general not constrained Delaunay afterwards.
void force_edge(PlainMesh& mesh, Index a, Index b);

/// Flips unconstrained edges until each is locally Delaunay; the mesh is constrained Delaunay then.
void flip_to_delaunay(PlainMesh& mesh);

/// All of it. Walls meet at most in common ends and run through no point.
[[nodiscard]] PlainMesh constrained_delaunay(const std::vector<Point>& points, const std::vector<Edge>& walls);

}  // namespace pardel::ref
