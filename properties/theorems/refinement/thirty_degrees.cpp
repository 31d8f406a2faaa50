#include "thirty_degrees.hpp"

#include <utility>

#include "../../../parallel/mesher.hpp"
#include "../../checker/check.hpp"

namespace pardel::properties {

testing::AssertionResult is_halved_down_to_the_floor(const Pslg& domain) {
  Goal goal{.min_angle_deg = 30};
  // How many triangles remain depends on the shortest edge, because each halving doubles them or ends them. With this
  // length, which is nearly twice the floor where they lie, many remain; with the floor itself, a few.
  for (const auto& [shortest, at_least] : {std::pair(0x1p-42 * 672, 1'000U), std::pair(0.0, 1U)}) {
    const Result<Meshed> at_thirty = mesh(domain, goal, {.min_edge = shortest});
    if (!at_thirty) return testing::AssertionFailure() << at_thirty.error().message;
    if (at_thirty->report.count(ExemptReason::min_edge) < at_least || at_thirty->report.goal_met())
      return testing::AssertionFailure() << at_thirty->mesh.triangles.size() << " triangles at 30 degrees";
  }
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
