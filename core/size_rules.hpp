// SizeRules: places of a domain at which edge lengths are wanted, as a file names them.
#pragma once

#include <cstddef>
#include <vector>

#include "pslg.hpp"

namespace pardel {

/// Lengths are finite and > 0, in units of the coordinates. `line`: where the rule is in its file, for messages;
/// 0: it is in no file.
struct SizeRules {
  /// A length at a point of the plane.
  struct AtPoint {
    Point place;
    double length = 0;
  };
  /// A length on all segments, and at all input points, with a marker.
  struct OnMarker {
    int marker = 0;
    double length = 0;
    std::size_t line = 0;
  };
  /// A length everywhere in the regions with an attribute.
  struct InRegion {
    double attribute = 0;
    double length = 0;
    std::size_t line = 0;
  };

  std::vector<AtPoint> points;
  std::vector<OnMarker> markers;
  std::vector<InRegion> regions;

  [[nodiscard]] bool empty() const { return points.empty() && markers.empty() && regions.empty(); }
};

}  // namespace pardel
