// Goal: what a mesh has to satisfy beyond conforming to its Pslg. The mesher aims at it, the checker
// judges by it.
#pragma once

#include <functional>
#include <limits>

#include "pslg.hpp"

namespace pardel {

struct Goal {
  /// No angle below this, in degrees, 0 (no bound) to 33. The default is the proven bound of Ruppert's
  /// algorithm: arcsin(1 / (2 sqrt 2)) = 20.7 degrees, circumradius-to-shortest-edge ratio sqrt 2.
  double min_angle_deg = 20.7;
  /// No triangle with a larger area.
  double max_area = std::numeric_limits<double>::infinity();
  /// No edge longer than this.
  double max_edge = std::numeric_limits<double>::infinity();
  /// Honour Region::max_area.
  bool region_caps = true;
  /// Sizing: the longest edge wanted at a point, > 0; a triangle is too large when its longest edge
  /// exceeds size(centroid). Empty: none. Must be pure and callable from several threads.
  std::function<double(Point)> size{};
  /// Truly Delaunay (every edge locally Delaunay) instead of constrained Delaunay.
  bool conforming = false;
  /// The domain is the convex hull of the points (implied when there are no segments).
  bool convex_hull = false;
};

}  // namespace pardel
