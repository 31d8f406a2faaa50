// Bounds on angles above 28 degrees, up to the largest one that the mesher accepts. Some rare domains are then refined
// down to the floor, and triangles remain that miss the bound.
#include <algorithm>
#include <set>

#include "../framework/shares.hpp"
#include "meshing.hpp"

namespace pardel::properties {
namespace {

PARDEL_PROPERTY(
    Refinement, with_steep_bounds_misses_none_that_it_does_not_list,
    {.statement = "With a bound on angles above 28 and up to 33 degrees, refinement ends. The mesh conforms to the "
                  "domain, is (constrained) Delaunay and keeps all bounds on size. An angle is below the bound only if "
                  "a small angle of the input causes it, or in a triangle that the report lists because of the floor "
                  "or of the precision of doubles. If it lists none, the mesh is certified.",
     .source = "properties/THEORY.md, refinement; docs/guarantees.md",
     .families = "lattice domains of every family, random goals with angles of 28 to 33 degrees"}) {
  Problem problem = some_problem(exhibit);
  problem.goal.min_angle_deg = *rc::gen::element(28.6, 29.5, 30.0, 31.0, 32.0, 33.0, 33.0);
  const Options options = some_options();
  const Meshed result = meshed(problem, exhibit, options);
  const Certificate certificate = check(problem.pslg, result.mesh, problem.goal);
  std::set<Index> listed;
  for (const Exemption& e : result.report.exempt)
    if (!justified(e.reason)) {
      RC_ASSERT(e.reason == ExemptReason::min_edge || e.reason == ExemptReason::precision);
      listed.insert(e.triangle);
    }
  if (result.report.goal_met()) require_valid(certificate);
  for (const Violation& v : certificate.violations) {
    if (v.kind != ViolationKind::small_angle) RC_FAIL(v.message());
    RC_ASSERT(listed.contains(v.ids.at(0)));
  }
  classify(problem.goal.min_angle_deg > 30, "a bound above 30 degrees", 40);
  classify(result.report.goal_met(), "no triangle misses the bound without a small angle of the input", 95);
  classify(result.report.inserted + result.report.segment_splits >= 20, "20 insertions or more", 30);
}

}  // namespace
}  // namespace pardel::properties
