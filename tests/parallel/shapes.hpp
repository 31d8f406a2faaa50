// Small domains that consist of polygons.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "../../core/pslg.hpp"

namespace pardel::testing {

inline void add_polygon(Pslg& pslg, const std::vector<Point>& corners, int marker = 0) {
  const auto n = static_cast<Index>(pslg.points.size()), m = static_cast<Index>(corners.size());
  pslg.points.insert(pslg.points.end(), corners.begin(), corners.end());
  for (Index i = 0; i < m; ++i) pslg.segments.push_back({n + i, n + (i + 1) % m, marker});
}
inline void add_square(Pslg& pslg, double side, Point at, int marker = 0) {
  add_polygon(pslg, {at, {at.x + side, at.y}, {at.x + side, at.y + side}, {at.x, at.y + side}}, marker);
}
/// A regular polygon around the origin, counter-clockwise from the direction of x.
inline Pslg regular_polygon(int n, double radius = 1) {
  Pslg pslg;
  std::vector<Point> corners;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * k / n;
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  add_polygon(pslg, corners);
  return pslg;
}
inline Pslg points_only(const std::vector<Point>& points) {
  Pslg pslg;
  pslg.points = points;
  return pslg;
}
/// A square with the points 0 to 3, counter-clockwise from the origin. Segment i starts at point i.
inline Pslg square(double side) {
  Pslg pslg;
  add_square(pslg, side, {0, 0});
  return pslg;
}

}  // namespace pardel::testing
