// The patches of equilateral triangles that fit into a domain.
#pragma once

#include <span>
#include <vector>

#include "../concurrency/threads.hpp"
#include "../triangulation/triangulation.hpp"
#include "patch.hpp"

namespace pardel::engine {

/// The patch of a region.
struct RegionPatch {
  Index region = no_index;
  Patch patch;
};

/// One patch for each region in which a triangle fits, in the order of the regions; it can consist of several parts.
/// Its points have a distance of at least 0.7 edges from the segments and the vertices of the region. The lattice has a
/// point at the lower left corner of the region's bounding box. `edges`: as for fill_domain().
[[nodiscard]] std::vector<RegionPatch> find_patches(const Triangulation& t, std::span<const double> edges,
                                                    const Threads& threads);

}  // namespace pardel::engine
