// Computes the neighbours of triangles from their corners.
#pragma once

#include <cstddef>

#include "mesh.hpp"

namespace pardel {

class StopSignal;

/// The largest number of triangles whose sides, three per triangle, can be numbered by an Index.
inline constexpr std::size_t max_mesh_triangles = (no_index - 1) / 3;

/// True if a mesh can have so many triangles.
[[nodiscard]] constexpr bool can_be_a_mesh(std::size_t triangles) { return triangles <= max_mesh_triangles; }

/// Computes Triangle::n of all triangles from Triangle::v. The orientation of the triangles does not matter. If more
/// than two triangles share an edge, the two triangles with the smallest indices become neighbours; the sides of the
/// other triangles at this edge are called surplus and get no_index. A triangle is never its own neighbour. Returns the
/// number of surplus sides, which is 0 if the mesh is a manifold.
/// Time O(triangles + points), on all threads if each edge has at most one triangle on each side. The result does not
/// depend on the number of threads. Extra memory: 12 bytes per triangle and 8 bytes per point.
/// Preconditions: every corner < points, and triangles.size() <= max_mesh_triangles.
/// `stop`: asked from pass to pass; it throws. Then the neighbours have no meaning. It may be null.
std::size_t rebuild_neighbours(Array<Triangle>& triangles, std::size_t points, StopSignal* stop = nullptr);

}  // namespace pardel
