// The checker gives a mesh in memory and the same mesh in a file the same verdict. Files do not contain the segment on
// which a vertex lies, so the chain of each segment has to follow from the vertices and the constrained edges.
#include "written_mesh.hpp"

#include <cmath>

#include "../../../parallel/mesher.hpp"
#include "../../../parallel/repair.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../../../properties/domains/generators/goals.hpp"
#include "../../../properties/theorems/framework/property.hpp"
#include "../../../properties/theorems/framework/rapidcheck_generators.hpp"
#include "../../../properties/theorems/framework/shares.hpp"

namespace pardel {
namespace {

/// A box with bundles of segments. The segments of a bundle start at one point and differ in direction by a few units
/// in the last place, so that a vertex on one of them is within the tolerance of others.
Pslg bundles(generators::Random& random) {
  const double x = double(random.below(1000)), width = 1 + double(random.below(400));
  Pslg pslg = domains::moved(domains::square(), x, -x / 3, width);
  const auto coordinate = [&] { return width * (0.1 + 0.8 * double(random.below(1'000'000)) / 1e6); };
  for (std::size_t i = 1 + random.below(3); i > 0; --i) {
    const auto apex = static_cast<Index>(pslg.points.size());
    pslg.points.push_back({x + coordinate(), -x / 3 + coordinate()});
    Point end{x + coordinate(), -x / 3 + coordinate()};
    for (std::size_t k = 2 + random.below(3); k > 0; --k) {
      pslg.segments.push_back({apex, static_cast<Index>(pslg.points.size()), int(k)});
      pslg.points.push_back(end);
      for (std::size_t ulps = 1 + random.below(4); ulps > 0; --ulps) end.y = std::nextafter(end.y, 1e9);
      const double share = 0.75 + double(random.below(3)) / 4;  // shorter, equal, longer
      const Point p = pslg.points[apex];
      end = {p.x + (end.x - p.x) * share, p.y + (end.y - p.y) * share};
    }
  }
  pslg.has_segment_markers = true;
  return pslg;
}

struct Problem {
  Pslg pslg;
  Goal goal;
  Options options{};
};

Problem lattice_problem() {
  const auto simpler = [](const generators::Case& c) { return generators::shrinks(c); };
  const generators::Case c = *generators::generator(generators::any_case, simpler);
  return {to_pslg(c.domain), to_goal(c.goal, c.domain)};
}

Problem problem_with_bundles() {
  generators::Random random(*rc::gen::arbitrary<std::uint32_t>());
  const Result<Repaired> repaired = repair(bundles(random), {.snap = 0});
  RC_PRE(repaired.ok());
  Problem problem{repaired->domain.pslg(), {.min_angle_deg = *rc::gen::element(0.0, 5.0, 20.7)}};
  problem.options.max_vertices = 200;
  return problem;
}

bool is_of_a_bound(ViolationKind kind) {
  return kind >= ViolationKind::small_angle && kind <= ViolationKind::large_circumradius;
}

PARDEL_PROPERTY(
    Certificate, of_a_mesh_and_of_its_files_are_the_same,
    {.statement = "The verdict on a mesh and its numbers of violations are the same in memory and after "
                  "writing and reading .node, .msh, .off or .vtu. In meshes of the mesher, all violations are "
                  "missed bounds.",
     .source = "properties/checker/model/chains.hpp",
     .families = "lattice domains of every family; a square with bundles of segments that nearly "
                 "coincide, repaired"}) {
  const Problem problem = *rc::gen::arbitrary<bool>() ? lattice_problem() : problem_with_bundles();
  exhibit.show(problem.pslg);
  const Result<Meshed> meshed = mesh(problem.pslg, problem.goal, problem.options);
  RC_ASSERT(meshed.ok());
  const Certificate certificate = check(problem.pslg, meshed->mesh, problem.goal);
  properties::classify(certificate.valid, "valid", 35);
  for (const Violation& violation : certificate.violations)
    if (!is_of_a_bound(violation.kind)) RC_FAIL(violation.message());
  const auto format = *rc::gen::elementOf(testing::formats_with_constrained_edges());
  RC_LOG() << format.file << '\n';
  RC_ASSERT(testing::verdict_on_file(problem.pslg, meshed->mesh, problem.goal, format) ==
            testing::verdict(certificate));
}

}  // namespace
}  // namespace pardel
