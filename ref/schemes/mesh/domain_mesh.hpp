// The conversion to the mesh that the checker examines.
#pragma once

#include "../../../core/mesh.hpp"
#include "linked_mesh.hpp"

namespace pardel::schemes {

/// The mesh with the markers of the program Triangle (../../faces.hpp, to_mesh()). Precondition: all faces are in use.
/// Linear time.
[[nodiscard]] Mesh to_mesh(const LinkedMesh& linked, const Pslg& pslg);

}  // namespace pardel::schemes
