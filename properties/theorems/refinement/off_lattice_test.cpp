// Refinement of inputs that differ from lattice domains: rounded coordinates, labels of points, bounds on edge lengths.
#include <algorithm>
#include <cmath>

#include "../../../core/digest.hpp"
#include "turned_problems.hpp"

namespace pardel::properties {
namespace {

constexpr const char* refinement_source = "properties/THEORY.md, refinement";

PARDEL_PROPERTY(Refinement, does_not_depend_on_the_direction_of_segments_where_coordinates_are_rounded,
                {.statement = "Reversing the direction of segments gives the same mesh, including rounded "
                              "coordinates.",
                 .source = refinement_source,
                 .families = turned_families}) {
  Problem problem = some_turned_problem(exhibit);
  const Mesh expected = meshed(problem, exhibit).mesh;
  for (Segment& s : problem.pslg.segments) std::swap(s.a, s.b);
  RC_ASSERT(digest(meshed(problem, exhibit).mesh) == digest(expected));
}

PARDEL_PROPERTY(Refinement, gives_a_certified_mesh_where_coordinates_are_rounded,
                {.statement = "The mesh of a valid domain meets the goal and is certified, even if every split point "
                              "has to be rounded.",
                 .source = refinement_source,
                 .families = turned_families}) {
  const Problem problem = some_turned_problem(exhibit);
  const Meshed result = meshed(problem, exhibit, some_options());
  RC_ASSERT(result.report.goal_met());
  require_valid(check(problem.pslg, result.mesh, problem.goal));
}

PARDEL_PROPERTY(Refinement, keeps_bounds_on_lengths,
                {.statement = "No edge is longer than the bound of the goal, nor longer than the value of the sizing "
                              "function at the centroids of its triangles.",
                 .source = refinement_source,
                 .families = every_family}) {
  Problem problem = some_problem(exhibit);
  double width = 0;
  const Point centre = problem.pslg.points[0];
  for (const Point p : problem.pslg.points)
    width = std::max({width, std::abs(p.x - centre.x), std::abs(p.y - centre.y)});
  const double least = width * 0.01 * *rc::gen::inRange(8, 50);
  if (*rc::gen::arbitrary<bool>())
    problem.goal.max_edge = least;
  else
    problem.goal.size = [=](Point p) { return least + 0.3 * std::hypot(p.x - centre.x, p.y - centre.y); };
  require_valid(check(problem.pslg, meshed(problem, exhibit).mesh, problem.goal));
}

PARDEL_PROPERTY(Refinement, keeps_the_labels_of_points,
                {.statement = "Input points keep their markers and attributes.",
                 .source = refinement_source,
                 .families = every_family}) {
  Problem problem = some_problem(exhibit);
  problem.pslg.attributes_per_point = 2;
  problem.pslg.point_markers.clear();
  problem.pslg.point_attributes.clear();
  for (std::size_t i = 0; i < problem.pslg.points.size(); ++i) {
    problem.pslg.point_markers.push_back(*rc::gen::inRange(0, 4));
    problem.pslg.point_attributes.insert(problem.pslg.point_attributes.end(), {double(i), 0.5 * double(i * i)});
  }
  require_valid(check(problem.pslg, meshed(problem, exhibit).mesh, problem.goal));
}

/// How far p has come on the way from a to b: 0 at a, 1 at b.
double share_of_way(Point a, Point p, Point b) {
  const double x = b.x - a.x, y = b.y - a.y;
  return ((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y);
}

PARDEL_PROPERTY(Refinement, interpolates_attributes_along_segments,
                {.statement = "An attribute of a vertex inside a segment is linear between the ends of the segment.",
                 .source = refinement_source,
                 .families = every_family}) {
  Problem problem = some_problem(exhibit);
  std::vector<double>& given = problem.pslg.point_attributes;
  problem.pslg.attributes_per_point = 1;
  given.clear();
  for (std::size_t i = 0; i < problem.pslg.points.size(); ++i) given.push_back(*rc::gen::inRange(-1000, 1000));
  const Mesh mesh = meshed(problem, exhibit).mesh;
  for (Index v = 0; v < mesh.points.size(); ++v) {
    const Index number = segment_of_origin(mesh.origin[v]);
    if (number >= problem.pslg.segments.size()) continue;
    const auto [a, b, marker] = problem.pslg.segments[number];
    const double share = share_of_way(problem.pslg.points[a], mesh.points[v], problem.pslg.points[b]);
    RC_ASSERT(std::abs(mesh.point_attributes[v] - std::lerp(given[a], given[b], share)) < 1e-5);
  }
}

}  // namespace
}  // namespace pardel::properties
