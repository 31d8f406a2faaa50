// The triangle on the left of a directed edge.
#pragma once

#include <optional>

#include "../../../ref/definitions.hpp"

namespace pardel::properties {

/// r² of the triangle on the left of the directed edge ab; nothing if there is no triangle.
[[nodiscard]] inline std::optional<ref::Number> squared_circumradius_left_of(const ref::PlainMesh& mesh, Index a,
                                                                             Index b) {
  for (const ref::Corners& t : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      if (t[i] == a && t[(i + 1) % 3] == b) return squared_circumradius(mesh, t);
  return std::nullopt;
}

}  // namespace pardel::properties
