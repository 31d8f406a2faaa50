// The regions of a refined mesh if the regions of the original mesh are not faces: no constrained edge separates them.
#pragma once

#include "../../core/mesh.hpp"
#include "../threads/threads.hpp"

namespace pardel::engine {

/// True if triangles of different regions meet at an edge that is not constrained. Precondition: neighbours are right.
/// O(n log n) for a mesh with regions.
[[nodiscard]] bool regions_mix(const Mesh& mesh);

/// Gives each triangle of `fine` the region of the triangle of `coarse` that contains its centroid. Preconditions: both
/// meshes cover the same domain, and `coarse` has regions. O(n log n) on typical input.
void locate_regions(const Mesh& coarse, Mesh& fine, const Threads& threads = {});

}  // namespace pardel::engine
