// Refinement of domains that mix scales. One part of a domain is meshed as well as without the other parts, however
// much larger, smaller or farther away these are.
#include "mixed_scales.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "../framework/shares.hpp"
#include "problems_to_fill.hpp"

namespace pardel::properties {
namespace {

constexpr const char* source_of_mixed_refinement = "properties/THEORY.md, refinement";

/// Fails the case if the checker finds anything wrong, or justifies other triangles than the report lists.
void require_certified(const Problem& problem, const Meshed& result) {
  const Certificate certificate = check(problem.pslg, result.mesh, problem.goal);
  require_valid(certificate);
  std::set<Index> reported, found;
  for (const Exemption& e : result.report.exempt) reported.insert(e.triangle);
  for (const Justified& j : certificate.justified) found.insert(j.triangle);
  RC_ASSERT(result.report.goal_met());
  RC_ASSERT(reported == found);
}

PARDEL_PROPERTY(Refinement, of_a_domain_that_mixes_scales_is_certified,
                {.statement = "The mesh of a domain that mixes scales is certified, also if its interior is filled. "
                              "The report lists exactly the triangles that the checker finds justified.",
                 .source = source_of_mixed_refinement,
                 .families = mixed_families}) {
  MixedProblem drawn = some_mixed_problem(exhibit);
  Options options = some_options();
  if (!drawn.mixed.enlarges && *rc::gen::inRange(0, 3) == 0) {
    options.interior = Interior::fill;
    drawn.problem.goal.max_area = box_area(drawn.mixed.parts.front()) / *rc::gen::inRange(30, 1000);
  }
  const Meshed result = meshed(drawn.problem, exhibit, options);
  classify(result.report.laid > 0, "with equilateral triangles", 5);
  require_certified(drawn.problem, result);
}

PARDEL_PROPERTY(Refinement, of_a_graded_domain_that_mixes_scales_is_certified,
                {.statement = "The mesh of a domain that mixes scales, for a limit on gradation or for edges across "
                              "narrow places, is certified.",
                 .source = "docs/sizes.md",
                 .families = mixed_families}) {
  MixedProblem drawn = some_mixed_problem(exhibit);
  Goal& goal = drawn.problem.goal;
  if (*rc::gen::arbitrary<bool>())
    goal.grading = *rc::gen::element(0.2, 0.5, 1.0);
  else
    goal.feature_edges = *rc::gen::element(0.5, 1.0, 2.0);
  require_certified(drawn.problem, meshed(drawn.problem, exhibit, some_options()));
}

PARDEL_PROPERTY(
    Refinement, is_hardly_changed_by_far_points_in_no_triangle,
    {.statement = "Far points outside of the domain change the number of triangles by at most a tenth and 20. (They "
                  "change tiles and the order of insertion, and so which of many equally good points are inserted.)",
     .source = source_of_mixed_refinement,
     .families = "lattice domains of every family, random goals; one to three points outside, 2^10 to 2^198 times as "
                 "far away as the domain reaches"}) {
  const MixedProblem drawn = some_mixed_problem(exhibit, {generators::Mixture::far_points_outside});
  Options options = some_options();
  options.triangles_per_tile = Options{}.triangles_per_tile;
  const Problem alone{drawn.mixed.parts.front(), drawn.problem.goal};
  const auto without = static_cast<double>(value_of(mesh(alone.pslg, alone.goal, options)).mesh.triangles.size());
  const auto with = static_cast<double>(meshed(drawn.problem, exhibit, options).mesh.triangles.size());
  classify(without > 100, "more than 100 triangles", 20);
  RC_ASSERT(with <= 1.1 * without + 20);
  RC_ASSERT(without <= 1.1 * with + 20);
}

}  // namespace
}  // namespace pardel::properties
