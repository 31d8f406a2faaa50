// Finds the face of the Pslg in which each triangle lies.
#pragma once

#include <vector>

#include "../model/adjacency.hpp"
#include "../model/chains.hpp"
#include "../model/domain.hpp"

namespace pardel::checker {

/// The face of the Pslg for each triangle. A triangle at a chain has the face on its side of the chain; from there the
/// face spreads across edges that belong to no chain. no_index for triangles that it does not reach. Linear time.
[[nodiscard]] std::vector<Index> paint_faces(const Domain& domain, const Adjacency& adjacency, const Chains& chains,
                                             StopSignal* stop = nullptr);

}  // namespace pardel::checker
