// Calls CGAL's Mesh_2 with plain data types. This part of CGAL is under the GPL, and so is every program compiled from
// a source that includes this file. Nothing that is installed contains it. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "../core/goal.hpp"
#include "../core/mesh.hpp"
#include "../core/neighbours.hpp"

namespace pardel::bench {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using MeshStructure = CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Kernel>,
                                                           CGAL::Delaunay_mesh_face_base_2<Kernel>>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel, MeshStructure>;

[[nodiscard]] inline double squared_sine(const Goal& goal) {
  const double sine = std::sin(goal.min_angle_deg * std::numbers::pi / 180);
  return sine * sine;
}

/// CGAL::Delaunay_mesh_size_criteria_2, but with the bounds of a Goal on areas and on edges that depend on the place,
/// so that all tools have the same goal. Triangles that are too large are split first, in decreasing size; then thin
/// triangles, in increasing angle.
class ShapeAndArea {
 public:
  struct Quality {
    double size = 0;  ///< the area, or the squared longest edge, divided by its bound
    double sine = 0;  ///< squared sine of the smallest angle
    bool operator<(const Quality& other) const {
      if (size > 1) return other.size > 1 ? size > other.size : true;
      return other.size > 1 ? false : sine < other.sine;
    }
  };

  class Is_bad {
   public:
    Is_bad(double sine_bound, double area_bound, const std::function<double(Point)>* size)
        : sine_bound_(sine_bound), area_bound_(area_bound), size_(size) {}

    CGAL::Mesh_2::Face_badness operator()(const Quality& quality) const {
      if (quality.size > 1) return CGAL::Mesh_2::IMPERATIVELY_BAD;
      return quality.sine < sine_bound_ ? CGAL::Mesh_2::BAD : CGAL::Mesh_2::NOT_BAD;
    }
    CGAL::Mesh_2::Face_badness operator()(const Constrained::Face_handle& face, Quality& quality) const {
      const auto &a = face->vertex(0)->point(), &b = face->vertex(1)->point(), &c = face->vertex(2)->point();
      const double area = CGAL::area(a, b, c);
      const double la = CGAL::squared_distance(b, c), lb = CGAL::squared_distance(c, a),
                   lc = CGAL::squared_distance(a, b);
      // The smallest angle lies opposite the shortest edge.
      quality.size = area / area_bound_;
      if (*size_) {
        const double wanted = (*size_)({(a.x() + b.x() + c.x()) / 3, (a.y() + b.y() + c.y()) / 3});
        quality.size = std::max(quality.size, std::max({la, lb, lc}) / (wanted * wanted));
      }
      quality.sine = 4 * area * area / (la * lb * lc) * std::min({la, lb, lc});
      return (*this)(quality);
    }

   private:
    double sine_bound_;
    double area_bound_;
    const std::function<double(Point)>* size_;
  };

  /// Keeps a reference to the goal.
  explicit ShapeAndArea(const Goal& goal) : goal_(goal) {}
  [[nodiscard]] Is_bad is_bad_object() const { return {squared_sine(goal_), goal_.max_area, &goal_.size}; }

 private:
  const Goal& goal_;
};

/// The faces for which `takes` returns true and their vertices, as plain data.
template <class Cgal, class Takes>
[[nodiscard]] Mesh plain(const Cgal& triangulation, const Takes& takes) {
  Mesh mesh;
  CGAL::Unique_hash_map<typename Cgal::Vertex_handle, Index> index(no_index);
  const auto vertex = [&](typename Cgal::Vertex_handle v) {
    Index& known = index[v];
    if (known == no_index) {
      known = static_cast<Index>(mesh.points.size());
      mesh.points.push_back({v->point().x(), v->point().y()});
    }
    return known;
  };
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f)
    if (takes(f)) mesh.triangles.push_back({{vertex(f->vertex(0)), vertex(f->vertex(1)), vertex(f->vertex(2))}, {}});
  rebuild_neighbours(mesh.triangles, mesh.points.size());
  return mesh;
}

[[nodiscard]] inline std::vector<Kernel::Point_2> cgal_points(const Pslg& pslg) {
  std::vector<Kernel::Point_2> points;
  points.reserve(pslg.points.size());
  for (const Point p : pslg.points) points.emplace_back(p.x, p.y);
  return points;
}

inline void constrain_hull(Constrained& cdt) {
  std::vector<Constrained::Vertex_handle> hull;
  const auto first = cdt.incident_vertices(cdt.infinite_vertex());
  auto v = first;
  do hull.push_back(v);
  while (++v != first);
  for (std::size_t i = 0; i < hull.size(); ++i) cdt.insert_constraint(hull[i], hull[(i + 1) % hull.size()]);
}

/// The refined constrained Delaunay triangulation of a Pslg. The hole points are passed to CGAL as seeds. If the Pslg
/// has no segments, the domain is its convex hull.
template <class Criteria>
[[nodiscard]] Constrained refined(const Pslg& pslg, const Criteria& criteria) {
  const auto points = cgal_points(pslg);
  Constrained cdt;
  if (pslg.segments.empty()) {
    cdt.insert(points.begin(), points.end());
    constrain_hull(cdt);
  } else {
    std::vector<std::pair<std::size_t, std::size_t>> segments;
    for (const Segment& s : pslg.segments) segments.emplace_back(s.a, s.b);
    cdt.insert_constraints(points.begin(), points.end(), segments.begin(), segments.end());
  }
  std::vector<Kernel::Point_2> seeds;
  for (const Point p : pslg.holes) seeds.emplace_back(p.x, p.y);
  CGAL::Delaunay_mesher_2<Constrained, Criteria> mesher(cdt, criteria);
  mesher.set_seeds(seeds.begin(), seeds.end());
  mesher.refine_mesh();
  return cdt;
}

}  // namespace pardel::bench
