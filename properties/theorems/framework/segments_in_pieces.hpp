// Domains with many points on their segments.
#pragma once

#include <utility>

#include "../../../core/pslg.hpp"

namespace pardel::properties {

/// Divides each segment into so many pieces. Where points are dense on segments, these are edges of the Delaunay
/// triangulation. The new points have markers and attributes if others have.
inline Pslg with_segments_in_pieces(Pslg pslg, Index pieces) {
  const bool marked = !pslg.point_markers.empty();
  for (const Segment& whole : std::exchange(pslg.segments, {})) {
    const Point a = pslg.points[whole.a], b = pslg.points[whole.b];
    Index last = whole.a;
    for (Index i = 1; i < pieces; ++i) {
      const double part = static_cast<double>(i) / pieces;
      pslg.points.push_back({a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)});
      if (marked) pslg.point_markers.push_back(static_cast<int>(i % 3));
      const auto next = static_cast<Index>(pslg.points.size() - 1);
      pslg.segments.push_back({last, next, whole.marker});
      last = next;
    }
    pslg.segments.push_back({last, whole.b, whole.marker});
  }
  pslg.point_attributes.resize(pslg.points.size() * pslg.attributes_per_point, 0.5);
  return pslg;
}

}  // namespace pardel::properties
