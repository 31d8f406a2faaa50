// Midpoints, lengths, areas and angles in floating-point arithmetic. No verdict depends on lengths, areas and angles
// that are computed here. A midpoint only locates the face that contains it.
#pragma once

#include <cmath>
#include <numbers>

#include "../../../core/pslg.hpp"
#include "../../../core/support/doubled_area.hpp"

namespace pardel::checker {

[[nodiscard]] inline Point midpoint(Point a, Point b) { return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2}; }

[[nodiscard]] inline double distance(Point a, Point b) { return std::hypot(b.x - a.x, b.y - a.y); }

using pardel::doubled_area;

/// The angle at `corner` between the rays to a and b, in degrees, from 0 to 180.
[[nodiscard]] inline double angle_deg(Point corner, Point a, Point b) {
  const double cross = std::abs(doubled_area(corner, a, b));
  const double dot = (a.x - corner.x) * (b.x - corner.x) + (a.y - corner.y) * (b.y - corner.y);
  return std::atan2(cross, dot) * 180 / std::numbers::pi;
}

}  // namespace pardel::checker
