// Segments of a .poly that are no part of its domain: a mesh of the domain need not have them as edges.
#pragma once

#include <vector>

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "faces.hpp"

namespace pardel::cli {

/// The edges of `drawn` that lie in a hole or outside: no part of the domain that all of `drawn` bounds is beside them,
/// and they enter no triangle of the mesh. `drawn`: pairs of vertices of the mesh. `holes`: a point in each hole. None
/// if `drawn` with these holes is no valid domain. Time O(n log n) for n edges and triangles.
[[nodiscard]] EdgeSet lines_in_holes(const Mesh& mesh, const std::vector<ConstrainedEdge>& drawn,
                                     const std::vector<Point>& holes);

}  // namespace pardel::cli
