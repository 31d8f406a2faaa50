// Two meshes made by hand, and what tests of the checker do with meshes.
#pragma once

#include <array>
#include <vector>

#include "../../../core/mesh.hpp"
#include "../../../core/neighbours.hpp"
#include "../../../core/pslg.hpp"
#include "../../../properties/checker/check.hpp"

namespace pardel::testing {

struct Case {
  Pslg pslg;
  Mesh mesh;
};

inline Goal no_angle_bound() {
  Goal goal;
  goal.min_angle_deg = 0;
  return goal;
}

inline Certificate check(const Case& c, const Goal& goal = no_angle_bound(), const CheckOptions& options = {}) {
  return pardel::check(c.pslg, c.mesh, goal, options);
}

/// Sets all neighbours from the corners.
inline void relink(Mesh& mesh) { rebuild_neighbours(mesh.triangles, mesh.points.size()); }

inline Mesh mesh_of(const std::vector<Point>& points, const std::vector<std::array<Index, 3>>& triangles) {
  Mesh mesh;
  mesh.points.append(points);
  for (const auto& corners : triangles) mesh.triangles.push_back({corners, {no_index, no_index, no_index}});
  mesh.origin.resize(points.size(), input_vertex);
  relink(mesh);
  return mesh;
}

/// The unit square in two triangles.
///   3---2
///   | / |
///   0---1
inline Case square_in_two() {
  Case c;
  c.pslg.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}};
  c.mesh = mesh_of(c.pslg.points, {{0, 1, 2}, {0, 2, 3}});
  c.mesh.constrained_edges = {{0, 1, 0, 1}, {1, 2, 1, 1}, {2, 3, 2, 1}, {3, 0, 3, 1}};
  return c;
}

/// The square [0, 4]^2 in eight right triangles around a vertex in the middle, with vertices in the middles of the
/// sides. Region 0 (attribute 7) lies on the left of the segment 4-5 (marker 9), region 1 (attribute 8) on its right.
///   3-----5-----2
///   |  \  |  /  |        segments 0-4, 4-1, 1-2, 2-5, 5-3, 3-0 around, 4-5 across
///   8-----6-----7        6, 7, 8 are not in the input
///   |  /  |  \  |
///   0-----4-----1
inline Case square_in_eight() {
  Case c;
  c.pslg.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 0}, {2, 4}};
  c.pslg.segments = {{0, 4, 5}, {4, 1, 0}, {1, 2, 0}, {2, 5, 0}, {5, 3, 0}, {3, 0, 0}, {4, 5, 9}};
  c.pslg.has_segment_markers = true;
  c.pslg.point_markers = {21, 0, 0, 0, 0, 0};
  c.pslg.regions = {{{1, 1}, 7, 3}, {{3, 3}, 8, 3}};
  std::vector<Point> points = c.pslg.points;
  points.insert(points.end(), {{2, 2}, {4, 2}, {0, 2}});
  c.mesh = mesh_of(points, {{0, 4, 6}, {4, 1, 6}, {1, 7, 6}, {7, 2, 6}, {2, 5, 6}, {5, 3, 6}, {3, 8, 6}, {8, 0, 6}});
  c.mesh.origin[6] = origin_on_segment(6);
  c.mesh.origin[7] = origin_on_segment(2);
  c.mesh.origin[8] = origin_on_segment(5);
  c.mesh.region.append(std::vector<Index>{0, 1, 1, 1, 1, 0, 0, 0});
  c.mesh.region_attributes = {7, 8};
  c.mesh.point_markers.append(std::vector<int>{21, 1, 1, 1, 9, 9, 9, 1, 1});
  c.mesh.constrained_edges = {{0, 4, 0, 5}, {4, 1, 1, 1}, {1, 7, 2, 1}, {7, 2, 2, 1}, {2, 5, 3, 1},
                              {5, 3, 4, 1}, {3, 8, 5, 1}, {8, 0, 5, 1}, {4, 6, 6, 9}, {6, 5, 6, 9}};
  return c;
}

}  // namespace pardel::testing
