// Statistics of a mesh in one pass of floating-point arithmetic, for reports. The checker's certificate has the same
// extremes with the triangles that attain them.
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

/// Angles are as accurate as the rounded coordinate differences of the corners. Angles, circumradius and area are 0 for
/// a mesh without triangles. Precondition: corners are in range, triangles are counter-clockwise. Linear time, one
/// thread, no memory.
[[nodiscard]] MeshStatistics statistics(const Mesh& mesh);

}  // namespace pardel
