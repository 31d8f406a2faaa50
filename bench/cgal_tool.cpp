// CGAL's Mesh_2 and Delaunay_triangulation_2. These parts of CGAL are under the GPL, and so is every program compiled
// from this file. Nothing that is installed contains it. SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_triangulation_2.h>

#include <cmath>

#include "../core/support/stopwatch.hpp"
#include "cgal_mesh_2.hpp"
#include "run_in_child.hpp"
#include "tool.hpp"

namespace pardel::bench {
namespace {

using Triangulation = CGAL::Delaunay_triangulation_2<Kernel>;

/// The squared bound on edges divided by the resulting mean area, measured on the pipe with a million triangles.
constexpr double squared_edge_per_mean_area = 5.0;

/// CGAL's own criteria bound the longest edge, not the area. The bound used here makes about as many triangles.
CGAL::Delaunay_mesh_size_criteria_2<Constrained> size_criteria(const Task& task) {
  const double mean_area = task.goal.max_area / triangles_per_cap;
  const double edge = std::isfinite(mean_area) ? std::sqrt(mean_area * squared_edge_per_mean_area) : 0;  // 0: no bound
  return {squared_sine(task.goal), edge};
}

template <class Criteria>
Run mesh_once(const Task& task, const Criteria& criteria) {
  Run run;
  const Pslg pslg = make_domain(task);
  const Stopwatch watch;
  const Constrained cdt = refined(pslg, criteria);
  run.seconds = watch.seconds();
  run.peak_rss_bytes = peak_rss_bytes();
  const Mesh mesh = plain(cdt, [](auto face) { return face->is_in_domain(); });
  judge(task, mesh, true, run);
  return run;
}

Run triangulate_once(const Task& task) {
  Run run;
  const Pslg pslg = make_domain(task);
  const auto points = cgal_points(pslg);
  const Stopwatch watch;
  Triangulation triangulation;
  triangulation.insert(points.begin(), points.end());  // CGAL sorts the points along a space-filling curve first
  run.seconds = watch.seconds();
  run.peak_rss_bytes = peak_rss_bytes();
  const Mesh mesh = plain(triangulation, [](auto) { return true; });
  judge(task, mesh, true, run);
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
            const ShapeAndArea criteria(task.goal);
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
