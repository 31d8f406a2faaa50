// Uniqueness of a Delaunay triangulation.
#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "../../../ref/definitions.hpp"

namespace pardel::properties {

/// Do two triangles with a common unconstrained edge have the same circumcircle? If not, the Delaunay triangulation is
/// unique.
[[nodiscard]] inline bool has_cocircular_neighbours(const ref::PlainMesh& mesh) {
  std::map<ref::Edge, std::vector<Index>> apexes;
  for (const ref::Corners& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) apexes[ref::edge_of(t, i)].push_back(t[i]);
  return std::ranges::any_of(apexes, [&](const auto& at) {
    const auto& [e, tips] = at;
    return tips.size() == 2 && !mesh.constraints.contains(e) &&
           CGAL::side_of_oriented_circle(mesh.points[e[0]], mesh.points[e[1]], mesh.points[tips[0]],
                                         mesh.points[tips[1]]) == CGAL::ON_ORIENTED_BOUNDARY;
  });
}

}  // namespace pardel::properties
