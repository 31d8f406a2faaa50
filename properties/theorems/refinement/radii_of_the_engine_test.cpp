// T2-once for the engine: the circumradii of its first triangulation bound those of the whole run, although the engine
// refines in parallel, rounds split points and uses lenses.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "../../../ref/radius_bound.hpp"
#include "../framework/shares.hpp"
#include "meshing.hpp"

namespace pardel::properties {
namespace {

double squared_radius(const Mesh& mesh, const Triangle& t) {
  const auto [a, b, c] = std::tuple(mesh.points[t.v[0]], mesh.points[t.v[1]], mesh.points[t.v[2]]);
  return CGAL::to_double(CGAL::squared_radius(ref::exact(a), ref::exact(b), ref::exact(c)));
}

double largest_squared_radius(const Mesh& mesh) {
  double largest = 0;
  for (const Triangle& t : mesh.triangles) largest = std::max(largest, squared_radius(mesh, t));
  return largest;
}

/// The factor of T2-once, squared: that of the segments of the first triangulation, and that of the engine's lens.
double squared_growth(const Mesh& first, double squared_start, double min_angle_deg) {
  Pslg pieces;
  pieces.points.assign(first.points.begin(), first.points.end());
  for (const ConstrainedEdge& e : first.constrained_edges) pieces.segments.push_back({e.a, e.b});
  const double of_segments = CGAL::to_double(ref::squared_growth_bound(pieces, ref::Number(squared_start)));
  const double sine = std::sin(2 * std::max(min_angle_deg, 20.7) * std::numbers::pi / 180);
  return std::max(of_segments, 1 / (sine * sine));
}

PARDEL_PROPERTY(T2Once, bounds_the_circumradii_of_the_engine_from_its_first_triangulation,
                {.statement = "Measure the largest circumradius of the triangulation of a domain once. No mesh after "
                              "any sweep of the engine exceeds it by more than the factor of T2-once.",
                 .source = "properties/THEORY.md, T2-once",
                 .families = every_family}) {
  const Problem problem = some_problem(exhibit);
  Options options = some_options();
  const Mesh first = value_of(triangulate(problem.pslg, problem.goal.convex_hull)).mesh;
  const double start = largest_squared_radius(first);
  const double bound = start * squared_growth(first, start, problem.goal.min_angle_deg) * (1 + 1e-9);
  double largest = 0;
  options.after_sweep = [&](const Mesh& mesh, const Sweep&) -> Status {
    largest = std::max(largest, largest_squared_radius(mesh));
    return Done{};
  };
  const Meshed result = meshed(problem, exhibit, options);
  largest = std::max(largest, largest_squared_radius(result.mesh));
  RC_ASSERT(largest <= bound);
  classify(largest > start, "circumradii grew", 1);
  classify(16 * largest > bound, "more than a quarter of the bound", 10);
}

}  // namespace
}  // namespace pardel::properties
