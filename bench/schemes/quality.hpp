// What the mesh of a scheme is like, whoever made it.
#pragma once

#include <cstddef>

#include "../../ref/schemes/mesh/linked_mesh.hpp"
#include "cases.hpp"

namespace pardel::bench {

struct SchemeQuality {
  std::size_t triangles = 0;
  double smallest_angle = 0;  ///< in degrees
  bool certified = false;     ///< by the checker, for the input and its goal
};

/// `refines` false: the mesh is only a triangulation, and meets no goal. Precondition: all faces are in use.
[[nodiscard]] SchemeQuality scheme_quality(const schemes::LinkedMesh& mesh, const SchemeInput& input, bool refines);

}  // namespace pardel::bench
