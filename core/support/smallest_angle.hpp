// The smallest angle of a triangle.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "../pslg.hpp"

namespace pardel {

/// The smallest angle of a triangle in degrees, which lies opposite the shortest edge; 0 if the triangle is flat.
[[nodiscard]] inline double smallest_angle(const std::array<Point, 3>& p) {
  const auto squared_length = [&](std::size_t i) {  // of the edge opposite corner i
    const Point& a = p[(i + 1) % 3];
    const Point& b = p[(i + 2) % 3];
    return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
  };
  const std::array<double, 3> lengths{squared_length(0), squared_length(1), squared_length(2)};
  const auto at = static_cast<std::size_t>(std::min_element(lengths.begin(), lengths.end()) - lengths.begin());
  const Point& a = p[(at + 1) % 3];
  const Point& b = p[(at + 2) % 3];
  const double ux = a.x - p[at].x, uy = a.y - p[at].y, vx = b.x - p[at].x, vy = b.y - p[at].y;
  return std::atan2(std::abs(ux * vy - uy * vx), ux * vx + uy * vy) * (180 / std::numbers::pi);
}

}  // namespace pardel
