// The triangles among which points are located.
#pragma once

#include <array>
#include <span>

#include "../../core/mesh.hpp"
#include "../arithmetic/box.hpp"
#include "../arithmetic/predicates.hpp"

namespace pardel::engine {

/// A view on the triangles of a mesh. Preconditions: their corners are points, the coordinates of these are usable, and
/// no triangle is turned.
struct LocatedTriangles {
  std::span<const Point> points;
  std::span<const Triangle> triangles;

  [[nodiscard]] std::array<Point, 3> corners(Index t) const {
    const auto& v = triangles[t].v;
    return {points[v[0]], points[v[1]], points[v[2]]};
  }
  [[nodiscard]] Box box(Index t) const {
    const auto c = corners(t);
    Box box = Box::around(c[0], c[1]);
    box.cover(Box::around(c[2]));
    return box;
  }
  /// True if p lies in the triangle or on its boundary. Exact. Precondition: the triangle is not flat.
  [[nodiscard]] bool contains(Index t, Point p) const {
    const auto c = corners(t);
    return orient2d(c[0], c[1], p) >= 0 && orient2d(c[1], c[2], p) >= 0 && orient2d(c[2], c[0], p) >= 0;
  }
};

}  // namespace pardel::engine
