// Meshing for angles above largest_min_angle_deg.
#pragma once

#include <functional>
#include <optional>

#include "../parallel/mesher.hpp"

namespace pardel::cli {

/// Runs the mesher on one input.
using RunMesher = std::function<Result<Meshed>(const Goal&, const Options&)>;

struct MeshedForAngle {
  Meshed meshed;
  Goal goal;                           ///< the goal for which the mesh was made
  std::optional<std::uint64_t> limit;  ///< if the angle had to be reduced: the limit on vertices that was reached
};

/// Makes a mesh for a goal whose smallest angle may exceed largest_min_angle_deg. Refinement for such an angle need not
/// end. Therefore it may insert as many vertices as options.max_vertices allows, or, if this is 0, six times as many
/// as the mesh for largest_min_angle_deg has, plus 1000. If this does not suffice, the mesh for largest_min_angle_deg
/// is the result.
[[nodiscard]] Result<MeshedForAngle> mesh_for_angle(const Goal& goal, const Options& options, const RunMesher& run);

}  // namespace pardel::cli
