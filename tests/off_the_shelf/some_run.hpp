// Problems and runs for properties of meshes with a sequential mesher.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "../../off_the_shelf/mesh_with_mesher.hpp"
#include "../../properties/theorems/refinement/meshing.hpp"

namespace pardel::properties {

inline constexpr const char* shelf_source = "docs/off-the-shelf.md";
inline constexpr const char* shelf_families =
    "lattice domains of every family, random goals, tasks of 4 to 60 triangles";

inline Scheme some_scheme() {
  const Scheme scheme = *rc::gen::element(Scheme::frozen, Scheme::cells, Scheme::decoupled);
  RC_TAG(std::string(name(scheme)));
  return scheme;
}
inline MesherOptions small_tasks(Scheme scheme) {
  MesherOptions how{.scheme = scheme};
  how.triangles_per_task = *rc::gen::element(4U, 15U, 60U);
  return how;
}
inline MeshedWithMesher run(const Problem& problem, SubdomainMesher& mesher, const MesherOptions& how,
                            const Options& options = {.threads = 1}) {
  const auto valid = validate(problem.pslg, {.convex_hull = problem.goal.convex_hull});
  RC_ASSERT(valid.ok());
  Result<MeshedWithMesher> result = mesh_with_mesher(*valid, problem.goal, mesher, how, options);
  if (!result) RC_FAIL(result.error().message);
  return std::move(*result);
}

/// Any case, with a bound on areas that a mesh of a few hundred triangles keeps, or sizes that grow from a place.
inline Problem some_fine_problem(Exhibit& exhibit) {
  Problem problem = some_problem(exhibit);
  const double extent = extent_of(problem.pslg);
  const int kind = *rc::gen::inRange(0, 4);
  RC_TAG(kind == 3 ? "graded" : "uniform");
  if (kind == 1 || kind == 2)
    problem.goal.max_area = std::min(problem.goal.max_area, extent * extent / *rc::gen::inRange(20, 400));
  if (kind == 3) {
    const Point centre = problem.pslg.points[*rc::gen::inRange<std::size_t>(0, problem.pslg.points.size())];
    const double least = extent / *rc::gen::inRange(20, 200), slope = 0.1 * *rc::gen::inRange(1, 8);
    problem.goal.size = [=](Point p) { return least + slope * std::hypot(p.x - centre.x, p.y - centre.y); };
  }
  return problem;
}

}  // namespace pardel::properties
