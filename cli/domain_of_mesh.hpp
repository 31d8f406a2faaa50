// The domain that a mesh covers, for a mesh that came without its Pslg.
#pragma once

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"

namespace pardel::cli {

/// The points of the mesh, its constrained edges and its boundary edges as segments, a seed in every hole.
/// The regions of the mesh become one seed for each of its triangulated faces that carries an attribute.
[[nodiscard]] Result<Pslg> domain_of(const Mesh& mesh);

}  // namespace pardel::cli
