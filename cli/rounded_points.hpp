// Recognizes a mesh whose file has rounded coordinates.
#pragma once

#include "../core/mesh.hpp"
#include "../properties/checker/certificate.hpp"

namespace pardel::cli {

/// True if input points are missing in the mesh, and each of the first ten that the certificate lists has a vertex that
/// differs from it by rounding only: in each coordinate by at most 1e-12 of this coordinate, and in one of them at all.
[[nodiscard]] bool are_input_points_rounded(const Certificate& certificate, const Mesh& mesh);

}  // namespace pardel::cli
