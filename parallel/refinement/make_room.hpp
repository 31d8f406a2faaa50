// Room for a point that splits an edge where a sliver lies on it.
#pragma once

#include <vector>

#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// Rounding moves a point p that splits the constrained edge e. If the apex of a triangle at e lies nearly on the line
/// of e, as where vertices of one chain form a triangle, p may lie on or beyond another side of it. Then the diagonals
/// around one end of e are flipped, one after the other, until p sees both other sides of the triangle at e; the same
/// on the other side of e. The result need not be Delaunay.
///
/// Returns e, as a side of the triangle that it now has; none() if flips cannot make room, and then nothing has
/// changed. Appends the triangles that have changed to `changed`.
[[nodiscard]] EdgeRef make_room(Triangulation& t, EdgeRef e, Point p, std::vector<TriangleId>& changed);

}  // namespace pardel::engine
