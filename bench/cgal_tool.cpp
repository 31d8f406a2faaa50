// CGAL's Mesh_2 and Delaunay_triangulation_2. These parts of CGAL are under the GPL, so this file is, as a
// compiled work, too; nothing that is installed contains it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Unique_hash_map.h>

#include <cmath>
#include <numbers>

#include "../core/neighbours.hpp"
#include "run_in_child.hpp"
#include "stopwatch.hpp"
#include "tool.hpp"

namespace pardel::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel>;
using MeshStructure = CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Kernel>,
                                                           CGAL::Delaunay_mesh_face_base_2<Kernel>>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel, MeshStructure>;

/// CGAL::Delaunay_mesh_size_criteria_2 with the area in place of the longest edge, so that the goal is the very
/// one that the other tools get: too large first (largest first), then too thin (thinnest first).
class ShapeAndArea {
 public:
  struct Quality {
    double size = 0;  ///< area over bound
    double sine = 0;  ///< squared sine of the smallest angle
    bool operator<(const Quality& other) const {
      if (size > 1) return other.size > 1 ? size > other.size : true;
      return other.size > 1 ? false : sine < other.sine;
    }
  };

  class Is_bad {
   public:
    Is_bad(double sine_bound, double area_bound) : sine_bound_(sine_bound), area_bound_(area_bound) {}

    CGAL::Mesh_2::Face_badness operator()(const Quality& quality) const {
      if (quality.size > 1) return CGAL::Mesh_2::IMPERATIVELY_BAD;
      return quality.sine < sine_bound_ ? CGAL::Mesh_2::BAD : CGAL::Mesh_2::NOT_BAD;
    }
    CGAL::Mesh_2::Face_badness operator()(const Constrained::Face_handle& face, Quality& quality) const {
      const auto &a = face->vertex(0)->point(), &b = face->vertex(1)->point(), &c = face->vertex(2)->point();
      const double area = CGAL::area(a, b, c);
      const double la = CGAL::squared_distance(b, c), lb = CGAL::squared_distance(c, a),
                   lc = CGAL::squared_distance(a, b);
      // The smallest angle lies opposite the shortest edge, between the other two.
      quality.size = area / area_bound_;
      quality.sine = 4 * area * area / (la * lb * lc) * std::min({la, lb, lc});
      return (*this)(quality);
    }

   private:
    double sine_bound_;
    double area_bound_;
  };

  ShapeAndArea(double sine_bound, double area_bound) : sine_bound_(sine_bound), area_bound_(area_bound) {}
  [[nodiscard]] Is_bad is_bad_object() const { return {sine_bound_, area_bound_}; }

 private:
  double sine_bound_;
  double area_bound_;
};

/// Points and triangles as plain values; `takes` says which faces are of the domain.
template <class Cgal, class Takes>
Mesh plain(const Cgal& triangulation, const Takes& takes) {
  Mesh mesh;
  CGAL::Unique_hash_map<typename Cgal::Vertex_handle, Index> index;
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v) {
    index[v] = static_cast<Index>(mesh.points.size());
    mesh.points.push_back({v->point().x(), v->point().y()});
  }
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f)
    if (takes(f)) mesh.triangles.push_back({{index[f->vertex(0)], index[f->vertex(1)], index[f->vertex(2)]}, {}});
  rebuild_neighbours(mesh.triangles, mesh.points.size());
  return mesh;
}

std::vector<Kernel::Point_2> cgal_points(const Pslg& pslg) {
  std::vector<Kernel::Point_2> points;
  points.reserve(pslg.points.size());
  for (const Point p : pslg.points) points.emplace_back(p.x, p.y);
  return points;
}

void constrain_hull(Constrained& cdt) {
  std::vector<Constrained::Vertex_handle> hull;
  const auto first = cdt.incident_vertices(cdt.infinite_vertex());
  auto v = first;
  do hull.push_back(v);
  while (++v != first);
  for (std::size_t i = 0; i < hull.size(); ++i) cdt.insert_constraint(hull[i], hull[(i + 1) % hull.size()]);
}

double squared_sine(const Goal& goal) {
  const double sine = std::sin(goal.min_angle_deg * std::numbers::pi / 180);
  return sine * sine;
}

/// Measured on the pipe at a million triangles: the squared bound on edges over the mean area that it leads to.
constexpr double squared_edge_per_mean_area = 5.0;

/// CGAL's own criteria, which know the longest edge and no area: a bound that leads to about as many triangles.
CGAL::Delaunay_mesh_size_criteria_2<Constrained> size_criteria(const Task& task) {
  const double mean_area = task.goal.max_area / triangles_per_cap;
  const double edge = std::isfinite(mean_area) ? std::sqrt(mean_area * squared_edge_per_mean_area) : 0;  // 0: no bound
  return {squared_sine(task.goal), edge};
}

template <class Criteria>
Run mesh_once(const Task& task, const Criteria& criteria) {
  Run run;
  const Pslg pslg = make_domain(task);
  const auto points = cgal_points(pslg);
  const Stopwatch watch;
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
  run.seconds = watch.seconds();
  run.peak_rss_bytes = peak_rss_bytes();
  const Mesh mesh = plain(cdt, [](auto face) { return face->is_in_domain(); });
  run.vertices = mesh.points.size();
  run.triangles = mesh.triangles.size();
  run.say(verdict(task, mesh, true));
  return run;
}

Run triangulate_once(const Task& task) {
  Run run;
  const Pslg pslg = make_domain(task);
  const auto points = cgal_points(pslg);
  const Stopwatch watch;
  Triangulation triangulation;
  triangulation.insert(points.begin(), points.end());  // sorts along a space-filling curve first
  run.seconds = watch.seconds();
  run.peak_rss_bytes = peak_rss_bytes();
  const Mesh mesh = plain(triangulation, [](auto) { return true; });
  run.vertices = mesh.points.size();
  run.triangles = mesh.triangles.size();
  run.say(verdict(task, mesh, true));
  return run;
}

}  // namespace

Tool cgal_size_tool() {
  return {"cgal-size", [](const Task& task) { return !task.delaunay_only && std::isfinite(task.goal.max_area); },
          [](const Task& task, const std::filesystem::path&) {
            return run_in_child<Run>([&] { return mesh_once(task, size_criteria(task)); }).value_or(Run{});
          }};
}

Tool cgal_mesh_tool() {
  return {"cgal-mesh", [](const Task& task) { return !task.delaunay_only; },
          [](const Task& task, const std::filesystem::path&) {
            const ShapeAndArea criteria(squared_sine(task.goal), task.goal.max_area);
            return run_in_child<Run>([&] { return mesh_once(task, criteria); }).value_or(Run{});
          }};
}

Tool cgal_delaunay_tool() {
  return {"cgal-delaunay", [](const Task& task) { return task.delaunay_only; },
          [](const Task& task, const std::filesystem::path&) {
            return run_in_child<Run>([&] { return triangulate_once(task); }).value_or(Run{});
          }};
}

}  // namespace pardel::bench
