// Meshes as sets of triangles, whatever their numbering, and whether they are Delaunay.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "../../../ref/schemes/mesh/linked_mesh.hpp"
#include "../../../ref/schemes/mesh/predicates.hpp"

namespace pardel::properties {

using PlacedTriangle = std::array<std::array<double, 2>, 3>;

/// The corners of each triangle in use, counter-clockwise, the lexicographically least first; sorted.
[[nodiscard]] inline std::vector<PlacedTriangle> placed_triangles(const schemes::LinkedMesh& mesh) {
  std::vector<PlacedTriangle> found;
  for (Index t = 0; t < mesh.faces.size(); ++t) {
    if (!mesh.in_use(t)) continue;
    PlacedTriangle corners;
    for (int i = 0; i < 3; ++i) corners[i] = {mesh.corner(t, i).x, mesh.corner(t, i).y};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    found.push_back(corners);
  }
  std::ranges::sort(found);
  return found;
}

/// Is every unconstrained side locally Delaunay, and every triangle positively oriented?
[[nodiscard]] inline bool is_locally_delaunay(const schemes::LinkedMesh& mesh) {
  for (Index t = 0; t < mesh.faces.size(); ++t) {
    if (!mesh.in_use(t)) continue;
    if (schemes::orientation(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)) <= 0) return false;
    for (int i = 0; i < 3; ++i) {
      if (mesh.faces[t].n[i] == no_index || schemes::is_constrained(mesh, {t, i})) continue;
      const schemes::Side twin = schemes::across(mesh, {t, i});
      if (schemes::circumdisk_contains(mesh, t, mesh.corner(twin.triangle, twin.i))) return false;
    }
  }
  return true;
}

}  // namespace pardel::properties
