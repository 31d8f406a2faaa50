#include "triangle.hpp"

#include <algorithm>

#include "../../../core/support/point_order.hpp"
#include "predicates.hpp"

namespace pardel::schemes {

bool covers(const LinkedMesh& mesh, Index t, Point p) {
  return orientation(mesh.corner(t, 0), mesh.corner(t, 1), p) >= 0 &&
         orientation(mesh.corner(t, 1), mesh.corner(t, 2), p) >= 0 &&
         orientation(mesh.corner(t, 2), mesh.corner(t, 0), p) >= 0;
}

int first_corner(const LinkedMesh& mesh, const Corners& v) {
  const auto less = [&](Index a, Index b) { return lexicographically_less(mesh.points[a], mesh.points[b]); };
  return static_cast<int>(std::min_element(v.begin(), v.end(), less) - v.begin());
}

std::array<double, 6> place_of(const LinkedMesh& mesh, const Corners& v) {
  std::array<double, 6> place{};
  const int first = first_corner(mesh, v);
  for (int i = 0; i < 3; ++i) {
    const Point p = mesh.points[v[(first + i) % 3]];
    place[static_cast<std::size_t>(2 * i)] = p.x;
    place[static_cast<std::size_t>(2 * i + 1)] = p.y;
  }
  return place;
}

}  // namespace pardel::schemes
