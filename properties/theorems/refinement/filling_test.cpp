// Fill: interiors of equilateral triangles. The statements are in properties/THEORY.md, Fill.
#include <algorithm>
#include <cmath>
#include <utility>

#include "../../../core/digest.hpp"
#include "../../../ref/definitions.hpp"
#include "../framework/shares.hpp"
#include "problems_to_fill.hpp"

namespace pardel::properties {
namespace {

constexpr const char* patch_source = "properties/THEORY.md, Fill";
constexpr const char* filled_families_of_large_angles =
    "lattice domains of every family, bounds on angles of 30 to 33 degrees, at most 5000 vertices; bounds on sizes as "
    "before";

PARDEL_PROPERTY(Fill, gives_a_mesh_that_the_checker_certifies,
                {.statement = "A mesh whose interior is filled with equilateral triangles conforms to the domain, is "
                              "(constrained) Delaunay and satisfies all bounds. The checker counts at least as many "
                              "equilateral triangles as were laid.",
                 .source = patch_source,
                 .families = filled_families}) {
  const Problem problem = some_problem_to_fill(exhibit);
  const Meshed result = meshed(problem, exhibit, filling_options());
  classify(result.report.laid > 0, "with equilateral triangles", 60);
  classify(result.report.laid > 500, "with more than 500 of them", 20);
  RC_ASSERT(result.report.goal_met());
  const Certificate certificate = check(problem.pslg, result.mesh, problem.goal);
  require_valid(certificate);
  RC_ASSERT(certificate.equilateral >= result.report.laid);
}

PARDEL_PROPERTY(Fill, does_not_depend_on_threads,
                {.statement = "One, two and three threads give the same mesh with the same numbering.",
                 .source = patch_source,
                 .families = filled_families}) {
  const Problem problem = some_problem_to_fill(exhibit);
  Options options = filling_options();
  const Mesh one = meshed(problem, exhibit, options).mesh;
  options.threads = *rc::gen::element(2, 3);
  RC_ASSERT(value_of(mesh(problem.pslg, problem.goal, options)).mesh == one);
}

PARDEL_PROPERTY(Fill, scaling_by_a_power_of_two_scales_the_mesh,
                {.statement = "If the coordinates of a domain are multiplied by 2^k, its bounds on edges by 2^k and "
                              "its bounds on areas by 4^k, the mesh is multiplied by 2^k.",
                 .source = patch_source,
                 .families = filled_families}) {
  Problem problem = some_problem_to_fill(exhibit);
  const Options options = filling_options();
  Mesh mesh = meshed(problem, exhibit, options).mesh;
  const double scale = std::ldexp(1.0, *rc::gen::inRange(-20, 21));
  const auto scaled = [&](Point p) { return Point{p.x * scale, p.y * scale}; };
  for (Point& p : mesh.points) p = scaled(p);
  for (Point& p : problem.pslg.points) p = scaled(p);
  for (Point& p : problem.pslg.holes) p = scaled(p);
  for (Region& region : problem.pslg.regions) {
    region.seed = scaled(region.seed);
    region.max_area *= scale * scale;
  }
  problem.goal.max_area *= scale * scale;
  problem.goal.max_edge *= scale;
  RC_ASSERT(digest(value_of(pardel::mesh(problem.pslg, problem.goal, options)).mesh) == digest(mesh));
}

/// Decides exactly if a vertex of the mesh lies in the open circumdisk of a triangle that is equilateral up to
/// rounding.
bool any_vertex_in_circumdisk(const Mesh& mesh, const Triangle& triangle) {
  ref::PlainMesh exactly;
  for (const Index v : triangle.v) exactly.points.push_back(ref::exact(mesh.points[v]));
  const Point a = mesh.points[triangle.v[0]], b = mesh.points[triangle.v[1]], c = mesh.points[triangle.v[2]];
  const Point centre{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
  const auto squared_distance = [&](Point p) {
    return (p.x - centre.x) * (p.x - centre.x) + (p.y - centre.y) * (p.y - centre.y);
  };
  constexpr double more_than_rounding = 1 + 1e-6;
  const double squared_reach = squared_distance(a) * more_than_rounding;
  return std::ranges::any_of(mesh.points, [&](Point p) {
    return squared_distance(p) < squared_reach && ref::circumdisk_contains(exactly, {0, 1, 2}, ref::exact(p));
  });
}

PARDEL_PROPERTY(Fill, no_vertex_enters_the_circumdisk_of_a_laid_triangle,
                {.statement = "No vertex of a mesh lies in the open circumdisk of an equilateral triangle that was "
                              "laid. This is decided exactly.",
                 .source = patch_source,
                 .families = filled_families}) {
  const Problem problem = some_problem_to_fill(exhibit);
  const Meshed result = meshed(problem, exhibit, filling_options());
  const auto& [mesh, report] = result;
  RC_PRE(report.laid > 0);
  const std::size_t first = mesh.triangles.size() - report.laid;
  std::size_t at_border = 0;
  for (std::size_t id = first; id < mesh.triangles.size(); ++id) {
    const Triangle& triangle = mesh.triangles[id];
    // Vertices of patches keep their distance. All others would have to come across a border.
    if (std::ranges::all_of(triangle.n, [&](Index across) { return across >= first; })) continue;
    ++at_border;
    RC_ASSERT(!any_vertex_in_circumdisk(mesh, triangle));
  }
  RC_ASSERT(at_border > 0U);
}

PARDEL_PROPERTY(Fill, takes_no_more_triangles_than_refinement,
                {.statement = "The filled mesh of a domain has no more triangles than the refined one. It has fewer in "
                              "most cases.",
                 .source = patch_source,
                 .families = filled_families}) {
  const Problem problem = some_problem_to_fill(exhibit);
  Options options{.interior = Interior::fill, .threads = 1};
  const Meshed filled = meshed(problem, exhibit, options);
  options.interior = Interior::refine;
  const std::size_t refined = value_of(mesh(problem.pslg, problem.goal, options)).mesh.triangles.size();
  classify(filled.mesh.triangles.size() < refined, "fewer triangles", 50);
  RC_ASSERT(filled.mesh.triangles.size() <= refined);
}

PARDEL_PROPERTY(Fill, meets_large_bounds_on_angles_wherever_refinement_does,
                {.statement = "Where the refinement cannot meet a large bound on angles beside equilateral triangles, "
                              "they give way or are given up, after a bounded number of restarts.",
                 .source = patch_source,
                 .families = filled_families_of_large_angles}) {
  Problem problem = some_problem_to_fill(exhibit);
  problem.goal.min_angle_deg = *rc::gen::element(30, 31, 32, 33);
  Options options = filling_options();
  options.max_vertices = 5000;
  const Meshed filled = meshed(problem, exhibit, options);
  classify(filled.report.restarts > 0, "with restarts", 20);
  classify(filled.report.laid > 0, "with equilateral triangles", 40);
  RC_ASSERT(filled.report.restarts <= 64U);
  options.interior = Interior::refine;
  const Meshed refined = value_of(mesh(problem.pslg, problem.goal, options));
  RC_ASSERT(filled.report.goal_met() || !refined.report.goal_met());
  if (filled.report.goal_met()) require_valid(check(problem.pslg, filled.mesh, problem.goal));
}

}  // namespace
}  // namespace pardel::properties
