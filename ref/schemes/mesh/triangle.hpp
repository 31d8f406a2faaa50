// One triangle of a mesh: where it lies, and whether it is still there.
#pragma once

#include "linked_mesh.hpp"

namespace pardel::schemes {

[[nodiscard]] inline Point centroid(Point a, Point b, Point c) {
  return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
}
[[nodiscard]] inline Point centroid(const LinkedMesh& mesh, Index t) {
  return centroid(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
}

/// Twice the area, positive for a counter-clockwise triangle; rounded.
[[nodiscard]] inline double twice_area(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
[[nodiscard]] inline double twice_area(const LinkedMesh& mesh, Index t) {
  return twice_area(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
}

/// Does p lie in the interior or on the border of t? Exact.
[[nodiscard]] bool covers(const LinkedMesh& mesh, Index t, Point p);

/// The coordinates of three corners, in their order, from the lexicographically least corner on: the same for a
/// triangle however its corners are numbered.
[[nodiscard]] std::array<double, 6> place_of(const LinkedMesh& mesh, const Corners& v);
/// The corner with which place_of() begins, 0 to 2.
[[nodiscard]] int first_corner(const LinkedMesh& mesh, const Corners& v);

/// A triangle with its corners. If its slot has other corners now, this triangle is gone.
struct KnownTriangle {
  Index triangle = no_index;
  Corners v{};
};
[[nodiscard]] inline KnownTriangle known(const LinkedMesh& mesh, Index t) { return {t, mesh.faces[t].v}; }
[[nodiscard]] inline bool is_current(const LinkedMesh& mesh, const KnownTriangle& k) {
  return mesh.faces[k.triangle].v == k.v;
}

}  // namespace pardel::schemes
