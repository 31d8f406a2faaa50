// Meshes as sets of triangles, whatever their numbering.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "../../../ref/schemes/mesh/linked_mesh.hpp"

namespace pardel::properties {

using PlacedTriangle = std::array<std::array<double, 2>, 3>;

/// The corners of each triangle in use, counter-clockwise, the lexicographically least first; sorted.
[[nodiscard]] inline std::vector<PlacedTriangle> placed_triangles(const schemes::LinkedMesh& mesh) {
  std::vector<PlacedTriangle> found;
  for (Index t = 0; t < mesh.faces.size(); ++t) {
    if (!mesh.in_use(t)) continue;
    PlacedTriangle corners;
    for (int i = 0; i < 3; ++i) corners[i] = {mesh.corner(t, i).x, mesh.corner(t, i).y};
    std::ranges::rotate(corners, std::ranges::min_element(corners));
    found.push_back(corners);
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace pardel::properties
