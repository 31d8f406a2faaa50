// The faces of a drawing, and the polygons that cover them.
#pragma once

#include <vector>

#include "drawn_domain.hpp"

namespace pardel::cli {

/// A face between the segments, within their convex hull.
struct DrawnFace {
  Point seed;            ///< the centroid of a triangle between the segments, so it is strictly inside
  bool is_open = false;  ///< it reaches the hull where there is no segment
  std::vector<const DrawnPolygon*> polygons{};  ///< those that cover it, in the order of the file
};

/// All faces. The polygons are those of `domain`, at least one. Segments that cross are repaired for this purpose; if
/// that fails, there are no faces. Time O(n log n) for n points if polygons cover each other nowhere.
[[nodiscard]] std::vector<DrawnFace> drawn_faces(const DrawnDomain& domain);

}  // namespace pardel::cli
