// Paints each triangle with the face of the Pslg that it lies in.
#pragma once

#include <vector>

#include "../model/adjacency.hpp"
#include "../model/chains.hpp"
#include "../model/domain.hpp"

namespace pardel::checker {

/// One face of the Pslg per triangle: known beside the chains, spread across all other edges. no_index where
/// no chain bounds the triangle's part of the mesh. Linear time.
[[nodiscard]] std::vector<Index> paint_faces(const Domain& domain, const Adjacency& adjacency, const Chains& chains);

}  // namespace pardel::checker
