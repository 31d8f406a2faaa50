// Search: split points that are chosen among several. The statements are in properties/THEORY.md, Search.
#include <algorithm>
#include <limits>

#include "../framework/shares.hpp"
#include "meshing.hpp"

namespace pardel::properties {
namespace {

constexpr const char* search_source = "properties/THEORY.md, Search";

PARDEL_PROPERTY(Search, changes_a_nearly_equilateral_mesh_only_near_the_boundary,
                {.statement = "A filled mesh, refined again with Placement::search for a bound on angles from 30 to 33 "
                              "degrees, gets at most four new triangles for each triangle that is not equilateral.",
                 .source = search_source,
                 .families = "lattice domains of every family, filled with triangles of a 1000th to a 10000th of the "
                             "bounding box at 20 degrees"}) {
  Problem problem = some_problem(exhibit);
  const auto [left, right] = std::ranges::minmax(problem.pslg.points, {}, &Point::x);
  const auto [bottom, top] = std::ranges::minmax(problem.pslg.points, {}, &Point::y);
  problem.goal = {.min_angle_deg = 20,
                  .max_area = (right.x - left.x) * (top.y - bottom.y) / *rc::gen::inRange(1000, 10'000)};
  const Meshed filled = meshed(problem, exhibit, {.interior = Interior::fill, .threads = 1});
  RC_PRE(filled.report.laid > 0 && filled.report.goal_met());
  const std::size_t before = filled.mesh.triangles.size(), others = before - filled.report.laid;
  classify(filled.report.laid > others, "mostly equilateral", 20);

  const Goal goal{.min_angle_deg = *rc::gen::element(30.0, 31.0, 32.0, 33.0)};
  const Meshed refined = value_of(refine(filled.mesh, {}, goal, {.placement = Placement::search, .threads = 1}));
  RC_PRE(refined.report.goal_met());
  RC_ASSERT(refined.mesh.triangles.size() - before <= 4 * others);
}

}  // namespace
}  // namespace pardel::properties
