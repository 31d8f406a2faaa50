#include "thirty_degrees.hpp"

#include "../../../parallel/mesher.hpp"
#include "../../checker/check.hpp"

namespace pardel::properties {

testing::AssertionResult is_halved_down_to_the_floor(const Pslg& domain) {
  Goal goal{.min_angle_deg = 30};
  const Result<Meshed> at_thirty = mesh(domain, goal);
  if (!at_thirty) return testing::AssertionFailure() << at_thirty.error().message;
  if (at_thirty->report.count(ExemptReason::min_edge) <= 1'000 || at_thirty->report.goal_met())
    return testing::AssertionFailure() << at_thirty->mesh.triangles.size() << " triangles at 30 degrees";
  for (const double below : {28.0, 29.0}) {
    goal.min_angle_deg = below;
    const Result<Meshed> good = mesh(domain, goal);
    if (!good) return testing::AssertionFailure() << good.error().message;
    if (good->mesh.triangles.size() >= 50 || !check(domain, good->mesh, goal).valid)
      return testing::AssertionFailure() << good->mesh.triangles.size() << " triangles at " << below << " degrees";
  }
  return testing::AssertionSuccess();
}

}  // namespace pardel::properties
