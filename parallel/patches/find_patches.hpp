// The patches of equilateral triangles that fit into a domain.
#pragma once

#include <span>
#include <vector>

#include "../threads/threads.hpp"
#include "../triangulation/triangulation.hpp"
#include "patch.hpp"

namespace pardel::engine {

/// A disk in which patches have no points.
struct Clearing {
  Point centre;
  double radius = 0;
};

/// The patch of a region.
struct RegionPatch {
  Index region = no_index;
  Patch patch;
};

/// The least distance of a patch from everything else, in edges. Necessary is more than 1 / sqrt 3: then the
/// circumdisks of the patch are empty, and nothing passes between its points.
inline constexpr double patch_clearance = 0.7;

/// One patch for each region in which a triangle fits, in the order of the regions; it can consist of several parts.
/// Its points have a distance of at least patch_clearance from the segments and the vertices of the region, and lie
/// outside all clearings. The lattice has a point at the lower left corner of the region's bounding box. `edges`: as
/// for Filling::make().
[[nodiscard]] std::vector<RegionPatch> find_patches(const Triangulation& t, std::span<const double> edges,
                                                    std::span<const Clearing> clearings, const Threads& threads);

}  // namespace pardel::engine
