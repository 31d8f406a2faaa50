// The sample mesh with fields and names.
#pragma once

#include <limits>
#include <vector>

#include "sample_mesh.hpp"

namespace pardel {

inline Mesh mesh_with_fields() {
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  Mesh mesh = sample_mesh();
  const auto add = [&](const char* name, Field::Place place, std::size_t components, std::vector<double> values) {
    mesh.fields.push_back({name, place, components, Array<double>(values), 0});
  };
  add("T", Field::Place::points, 1, {1, 2.5, -3, 1e-300, 1e300, missing});
  add("speed & <more>", Field::Place::points, 2, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, missing});
  add("heat", Field::Place::triangles, 1, {10, missing, 30, 40});
  add("flow", Field::Place::triangles, 3, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
  mesh.names = {{GroupName::Of::marker, 1, "wall \"of\" the tank"}, {GroupName::Of::region, 7, "water"}};
  return mesh;
}

}  // namespace pardel
