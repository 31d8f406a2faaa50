// A domain with all data that a mesh inherits.
#pragma once

#include "../../../properties/domains/domains.hpp"

namespace pardel {

/// A square with regions, a point in its hole, markers, and attributes of points: the first one varies.
inline Pslg square_with_data(std::size_t attributes_per_point = 1) {
  Pslg pslg = domains::regions();
  pslg.attributes_per_point = attributes_per_point;
  for (std::size_t v = 0; v < pslg.points.size(); ++v) {
    pslg.point_attributes.push_back(3 * pslg.points[v].x - pslg.points[v].y);
    pslg.point_attributes.resize(attributes_per_point * (v + 1), 0.1);
    pslg.point_markers.push_back(v % 3 == 0 ? static_cast<int>(v) : 0);
  }
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) pslg.segments[s].marker = s % 2 == 0 ? static_cast<int>(s) : 0;
  return pslg;
}

}  // namespace pardel
