// Finds the face of the Pslg in which each triangle lies.
#pragma once

#include <vector>

#include "../model/adjacency.hpp"
#include "../model/chains.hpp"
#include "../model/domain.hpp"

namespace pardel::checker {

/// The face of the Pslg for each triangle. The face is known for triangles at chains and spreads across all other
/// edges. no_index where no chain bounds the triangle's part of the mesh. Linear time.
[[nodiscard]] std::vector<Index> paint_faces(const Domain& domain, const Adjacency& adjacency, const Chains& chains);

}  // namespace pardel::checker
