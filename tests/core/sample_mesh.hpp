// A mesh in which every array is filled: a square of side 2, divided into four triangles at its centre. The left and
// right triangles have the region attribute 7, the others 2.5. One vertex belongs to no triangle.
#pragma once

#include "../../core/mesh.hpp"

namespace pardel {

inline Mesh sample_mesh() {
  Mesh mesh;
  for (const Point& p : {Point{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}, {5, 5}}) mesh.points.push_back(p);
  mesh.triangles.push_back({{0, 1, 4}, {1, 3, no_index}});
  mesh.triangles.push_back({{1, 2, 4}, {2, 0, no_index}});
  mesh.triangles.push_back({{2, 3, 4}, {3, 1, no_index}});
  mesh.triangles.push_back({{3, 0, 4}, {0, 2, no_index}});
  for (const Index r : {0u, 1u, 0u, 1u}) mesh.region.push_back(r);
  mesh.region_attributes = {2.5, 7};
  mesh.constrained_edges = {
      {0, 1, no_index, 1}, {1, 2, no_index, 5}, {2, 3, no_index, 1}, {3, 0, no_index, -4}, {2, 4, no_index, 0}};
  for (const int m : {1, 5, 5, 1, 9, 0}) mesh.point_markers.push_back(m);
  mesh.attributes_per_point = 1;
  for (const double a : {0.5, 1.5, 0.1, -3.0, 1e-300, 1e300}) mesh.point_attributes.push_back(a);
  return mesh;
}

}  // namespace pardel
