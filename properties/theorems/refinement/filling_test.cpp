// Fill: interiors of equilateral triangles. The statements are in properties/THEORY.md, Fill.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "../../../core/digest.hpp"
#include "../framework/shares.hpp"
#include "meshing.hpp"

namespace pardel::properties {
namespace {

constexpr const char* patch_source = "properties/THEORY.md, Fill";
constexpr const char* filled_families =
    "lattice domains of every family, random goals up to 29.9 degrees; bounds on areas from a 30th to a 3000th of the "
    "bounding box, bounds on edges, and caps per region";

double box_area(const Pslg& pslg) {
  const auto [left, right] = std::ranges::minmax(pslg.points, {}, &Point::x);
  const auto [bottom, top] = std::ranges::minmax(pslg.points, {}, &Point::y);
  return (right.x - left.x) * (top.y - bottom.y);
}

/// A random problem with constant bounds on sizes.
Problem some_problem_to_fill(Exhibit& exhibit) {
  Problem problem = some_problem(exhibit);
  Goal& goal = problem.goal;
  goal.min_angle_deg = std::min(goal.min_angle_deg, 29.9);
  const double area = box_area(problem.pslg) / *rc::gen::inRange(30, 3000);
  goal.max_area = goal.max_edge = std::numeric_limits<double>::infinity();
  if (*rc::gen::inRange(0, 4) == 0)
    goal.max_edge = 1.5 * std::sqrt(area);
  else
    goal.max_area = area;
  for (Region& region : problem.pslg.regions)
    if (*rc::gen::arbitrary<bool>()) region.max_area = area / *rc::gen::element(1, 4, 16);
  return problem;
}

Options filling_options() {
  Options options = some_options();
  options.interior = Interior::fill;
  return options;
}

PARDEL_PROPERTY(Fill, gives_a_mesh_that_the_checker_certifies,
                {.statement = "A mesh whose interior is filled with equilateral triangles conforms to the domain, is "
                              "(constrained) Delaunay and satisfies all bounds.",
                 .source = patch_source,
                 .families = filled_families}) {
  const Problem problem = some_problem_to_fill(exhibit);
  const Meshed result = meshed(problem, exhibit, filling_options());
  classify(result.report.laid > 0, "with equilateral triangles", 60);
  classify(result.report.laid > 500, "with more than 500 of them", 20);
  RC_ASSERT(result.report.goal_met());
  require_valid(check(problem.pslg, result.mesh, problem.goal));
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

PARDEL_PROPERTY(Fill, seldom_takes_more_triangles_than_refinement,
                {.statement = "The filled mesh of a domain has at most 1.3 times as many triangles as the refined one. "
                              "It has fewer in most cases.",
                 .source = "measured",
                 .families = filled_families}) {
  const Problem problem = some_problem_to_fill(exhibit);
  Options options{.interior = Interior::fill, .threads = 1};
  const Meshed filled = meshed(problem, exhibit, options);
  RC_PRE(filled.report.laid > 0);
  options.interior = Interior::refine;
  const auto refined = static_cast<double>(value_of(mesh(problem.pslg, problem.goal, options)).mesh.triangles.size());
  const auto triangles = static_cast<double>(filled.mesh.triangles.size());
  classify(triangles <= refined, "no more triangles", 70);
  RC_ASSERT(triangles <= 1.3 * refined + 8);
}

}  // namespace
}  // namespace pardel::properties
