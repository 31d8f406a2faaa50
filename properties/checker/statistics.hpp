// What a mesh looks like in a few numbers, by one pass of floating-point arithmetic. The checker's
// certificate has the same extremes with witnesses; this is for reports.
#pragma once

#include <cstdint>

#include "../../core/mesh.hpp"

namespace pardel {

struct MeshStatistics {
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  double min_angle_deg = 0;
  double max_angle_deg = 0;
  double max_circumradius = 0;
  double area = 0;  ///< sum over the triangles
};

/// Linear time. Angles are accurate to rounding of the corners' coordinate differences; all are 0 for a
/// mesh without triangles.
[[nodiscard]] MeshStatistics statistics(const Mesh& mesh);

}  // namespace pardel
