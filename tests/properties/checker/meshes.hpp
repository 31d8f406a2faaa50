// Meshes that the mesher did not make: two made by hand, and any domain triangulated or refined by CGAL.
#pragma once

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <map>
#include <vector>

#include "../../../core/mesh.hpp"
#include "../../../core/neighbours.hpp"
#include "../../../core/pslg.hpp"
#include "../../../properties/checker/check.hpp"
#include "../../../properties/checker/model/domain.hpp"

namespace pardel::testing {

using checker::Domain;
using checker::Side;

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
  c.mesh.origin[6] = 6;
  c.mesh.origin[7] = 2;
  c.mesh.origin[8] = 5;
  c.mesh.region.append(std::vector<Index>{0, 1, 1, 1, 1, 0, 0, 0});
  c.mesh.region_attributes = {7, 8};
  c.mesh.point_markers.append(std::vector<int>{21, 1, 1, 1, 9, 9, 9, 1, 1});
  c.mesh.constrained_edges = {{0, 4, 0, 5}, {4, 1, 1, 1}, {1, 7, 2, 1}, {7, 2, 2, 1}, {2, 5, 3, 1},
                              {5, 3, 4, 1}, {3, 8, 5, 1}, {8, 0, 5, 1}, {4, 6, 6, 9}, {6, 5, 6, 9}};
  return c;
}

/// The constrained Delaunay triangulation of a valid Pslg by CGAL, with all arrays that a mesh from the mesher has.
inline Mesh triangulated_by_cgal(const Pslg& pslg) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;
  const Domain domain(pslg, false);
  Cdt cdt;
  std::vector<Cdt::Vertex_handle> vertices;
  std::map<Cdt::Vertex_handle, Index> number;
  for (const Point p : pslg.points) {
    vertices.push_back(cdt.insert(Kernel::Point_2(p.x, p.y)));
    number[vertices.back()] = static_cast<Index>(number.size());
  }
  for (const Segment& s : domain.segments()) cdt.insert_constraint(vertices[s.a], vertices[s.b]);
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> face_of;
  for (const auto face : cdt.finite_face_handles()) {
    const std::array<Index, 3> v{number[face->vertex(0)], number[face->vertex(1)], number[face->vertex(2)]};
    const Point a = pslg.points[v[0]], b = pslg.points[v[1]], c = pslg.points[v[2]];
    const Index at = domain.faces().face_at({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3});
    if (!domain.inside(at)) continue;
    triangles.push_back(v);
    face_of.push_back(at);
  }
  Mesh mesh = mesh_of(pslg.points, triangles);
  for (Index s = 0; s < domain.segments().size(); ++s) {
    if (!domain.has(s)) continue;
    const Segment& segment = domain.segments()[s];
    const int marker = segment.marker != 0 ? segment.marker : domain.on_boundary(s) ? 1 : 0;
    mesh.constrained_edges.push_back({segment.a, segment.b, domain.is_hull_piece(s) ? no_index : s, marker});
  }
  for (const Region& region : pslg.regions) mesh.region_attributes.push_back(region.attribute);
  for (const Index face : face_of) {
    const auto regions = domain.regions_in(face);
    if (!pslg.regions.empty()) mesh.region.push_back(regions.empty() ? no_index : regions[0].second);
  }
  return mesh;
}

/// A quality mesh by CGAL Mesh_2. It has only corners and coordinates, like a mesh from a file. Angles are at least
/// 20.6 degrees (Mesh_2's default bound) if the input has no small angles.
inline Mesh refined_by_cgal(const Pslg& pslg, double max_edge) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Structure = CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Kernel>,
                                                         CGAL::Delaunay_mesh_face_base_2<Kernel>>;
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
  using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Cdt>;
  Cdt cdt;
  std::vector<Cdt::Vertex_handle> vertices;
  for (const Point p : pslg.points) vertices.push_back(cdt.insert(Kernel::Point_2(p.x, p.y)));
  for (const Segment& s : pslg.segments) cdt.insert_constraint(vertices[s.a], vertices[s.b]);
  std::vector<Kernel::Point_2> seeds;
  for (const Point p : pslg.holes) seeds.emplace_back(p.x, p.y);
  CGAL::Delaunay_mesher_2<Cdt, Criteria> mesher(cdt, Criteria(0.125, max_edge));
  mesher.set_seeds(seeds.begin(), seeds.end(), false);
  mesher.refine_mesh();
  std::map<Cdt::Vertex_handle, Index> number;
  std::vector<Point> points;
  std::vector<std::array<Index, 3>> triangles;
  for (const auto face : cdt.finite_face_handles()) {
    if (!face->is_in_domain()) continue;
    std::array<Index, 3> corners{};
    for (int i = 0; i < 3; ++i) {
      const auto v = face->vertex(i);
      const auto [entry, fresh] = number.emplace(v, static_cast<Index>(points.size()));
      if (fresh) points.push_back({v->point().x(), v->point().y()});
      corners[i] = entry->second;
    }
    triangles.push_back(corners);
  }
  Mesh mesh = mesh_of(points, triangles);
  mesh.origin.clear();
  return mesh;
}

}  // namespace pardel::testing
