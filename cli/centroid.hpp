// The centroid of a triangle.
#pragma once

#include "../core/mesh.hpp"

namespace pardel::cli {

/// Computed from differences to the first corner, so that it stays accurate far from the origin.
[[nodiscard]] inline Point centroid(const Mesh& mesh, const Triangle& t) {
  const Point a = mesh.points[t.v[0]], b = mesh.points[t.v[1]], c = mesh.points[t.v[2]];
  return {a.x + ((b.x - a.x) + (c.x - a.x)) / 3, a.y + ((b.y - a.y) + (c.y - a.y)) / 3};
}

}  // namespace pardel::cli
