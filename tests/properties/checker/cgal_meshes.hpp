// Meshes that CGAL makes of any domain.
#pragma once

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <map>
#include <vector>

#include "../../../properties/checker/model/domain.hpp"
#include "meshes.hpp"

namespace pardel::testing {

using checker::Domain;

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
