// Circumradii as upper bounds: the conditions on cells must hold in spite of rounding.
#pragma once

#include <algorithm>
#include <cmath>

#include "../mesh/linked_mesh.hpp"

namespace pardel::schemes::cells {

/// Relative errors of rounding are below this.
inline constexpr double rounding = 0x1p-40;

/// At least the circumradius of t; infinity if rounding hides the area of t.
[[nodiscard]] inline double circumradius(const LinkedMesh& mesh, Index t) {
  const Point a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
  const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const double error = rounding * (std::abs(bx * cy) + std::abs(by * cx));
  const double twice_area = bx * cy - by * cx - error;
  if (!(twice_area > 0)) return INFINITY;
  const double product = std::hypot(bx, by) * std::hypot(cx, cy) * std::hypot(bx - cx, by - cy);
  return product / (2 * twice_area) * (1 + rounding);
}

/// The largest circumradius of a mesh. All faces are in use or free.
[[nodiscard]] inline double largest_circumradius(const LinkedMesh& mesh) {
  double largest = 0;
  for (Index t = 0; t < mesh.faces.size(); ++t)
    if (mesh.in_use(t)) largest = std::max(largest, circumradius(mesh, t));
  return largest;
}

}  // namespace pardel::schemes::cells
