// The points of a mesh with their attributes, to compare meshes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "../../../core/mesh.hpp"

namespace pardel::properties {

/// The points of a mesh with their attributes, sorted. Those of a piece are among those of the whole.
inline std::vector<std::vector<double>> points_and_attributes(const Mesh& mesh) {
  const std::size_t k = mesh.attributes_per_point;
  std::vector<std::vector<double>> all;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    std::vector<double>& point = all.emplace_back(std::vector{mesh.points[v].x, mesh.points[v].y});
    for (std::size_t a = 0; a < k; ++a) point.push_back(mesh.point_attributes[k * v + a]);
  }
  std::ranges::sort(all);
  return all;
}

}  // namespace pardel::properties
