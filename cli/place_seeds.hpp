// The holes and regions of a domain that is drawn as polygons.
#pragma once

#include "drawn_domain.hpp"

namespace pardel::cli {

/// Puts a seed into each face between the segments: a hole where no polygon is or a polygon that is a hole, and a
/// region where the last polygon that covers the face has an attribute or a cap; the other value is then 0 or infinity.
/// A seed is the centroid of a triangle between the segments, so it is strictly inside. If all polygons are holes, the
/// rest is drawn by lines, and only these are holes; without polygons there are no seeds. Segments that cross are
/// repaired for this purpose; if that fails, the domain stays without seeds, and its validation finds the reason. Time
/// O(n log n) for n points if polygons cover each other nowhere.
[[nodiscard]] Pslg place_seeds(DrawnDomain domain);

}  // namespace pardel::cli
