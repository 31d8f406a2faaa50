// The domain that a mesh covers, for a mesh without a Pslg.
#pragma once

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"

namespace pardel::cli {

/// A Pslg with the points of the mesh, its constrained edges and its boundary edges as segments, one point in each
/// hole, and one region for each face whose triangles carry an attribute. O(n log n).
[[nodiscard]] Result<Pslg> domain_of(const Mesh& mesh);

}  // namespace pardel::cli
