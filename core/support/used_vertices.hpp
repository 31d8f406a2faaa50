// The vertices of a mesh that its triangles use.
#pragma once

#include <vector>

#include "../mesh.hpp"

namespace pardel {

/// One per vertex: 1 if it is a corner of a triangle, else 0. O(n).
[[nodiscard]] inline std::vector<char> used_vertices(const Mesh& mesh) {
  std::vector<char> is_used(mesh.points.size(), 0);
  for (const Triangle& triangle : mesh.triangles)
    for (const Index v : triangle.v) is_used[v] = 1;
  return is_used;
}

}  // namespace pardel
