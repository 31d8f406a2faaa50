#include "large_angle.hpp"

#include <utility>

namespace pardel::cli {

Result<MeshedForAngle> mesh_for_angle(const Goal& goal, const Options& options, const RunMesher& run) {
  const bool ends = goal.min_angle_deg <= largest_min_angle_deg || options.max_vertices > 0;
  Goal safe = goal;
  if (!ends) safe.min_angle_deg = largest_min_angle_deg;
  Result<Meshed> sure = run(safe, options);
  if (!sure) return sure.error();
  if (ends) return MeshedForAngle{std::move(*sure), goal, std::nullopt};

  Options limited = options;
  // The interior of the mesh for the largest sure angle may be filled. Then it has a third fewer vertices.
  limited.max_vertices = 6 * sure->mesh.points.size() + 1000;
  Result<Meshed> meshed = run(goal, limited);
  if (!meshed) return meshed.error();
  if (meshed->report.count(ExemptReason::budget) == 0) return MeshedForAngle{std::move(*meshed), goal, std::nullopt};
  return MeshedForAngle{std::move(*sure), std::move(safe), limited.max_vertices};
}

}  // namespace pardel::cli
