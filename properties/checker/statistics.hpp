// Statistics of a mesh for reports, computed in floating-point arithmetic in one pass over the triangles. The checker's
// certificate has the same extreme values, and for each the triangle that attains it.
#pragma once

#include <cstdint>

#include "../../core/mesh.hpp"

namespace pardel {

/// Angles are in degrees, the circumradius in the unit of the coordinates, the area in its square.
struct MeshStatistics {
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  double min_angle_deg = 0;
  double max_angle_deg = 0;
  double max_circumradius = 0;
  double area = 0;  ///< the sum of the areas of all triangles
};

/// Angles are computed from rounded differences of coordinates, which limit their accuracy. Angles, circumradius and
/// area are 0 for a mesh without triangles. Preconditions: corners are in range, triangles are counter-clockwise.
/// Linear time, on all threads. The result does not depend on the number of threads.
[[nodiscard]] MeshStatistics statistics(const Mesh& mesh);

}  // namespace pardel
