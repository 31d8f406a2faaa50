// Who shares an edge with whom, from the corners of triangles alone.
#pragma once

#include <cstddef>

#include "mesh.hpp"

namespace pardel {

/// The most triangles whose corners an Index can count.
inline constexpr std::size_t max_mesh_triangles = (no_index - 1) / 3;

/// Sets Triangle::n of all from Triangle::v. Where more than two triangles have an edge, the first two (by
/// index) are neighbours and the surplus ones get no_index there; a triangle is no neighbour of itself.
/// Returns the number of surplus sides: 0 where the mesh is a manifold. Orientation plays no part.
/// O(triangles + points) time; 12 bytes per triangle and 8 per point of memory besides.
/// Preconditions: every corner < points, triangles.size() <= max_mesh_triangles.
std::size_t rebuild_neighbours(Array<Triangle>& triangles, std::size_t points);

}  // namespace pardel
