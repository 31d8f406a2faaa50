// Chains of edges, for the formats that list the nodes of a line in their order.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "../pslg.hpp"

namespace pardel::files {

using EdgeEnds = std::array<Index, 2>;
/// The vertices of a chain in their order, at least two. The first one is repeated at the end if the chain is closed.
using Chain = std::vector<Index>;

/// Joins edges to chains. Each edge is in one chain. A chain ends at vertices where not exactly two edges meet. It has
/// the direction of its edges if these agree. If the edges of the chains, in their order, are joined again, the same
/// chains result. Time O(n log n) for n edges.
[[nodiscard]] std::vector<Chain> chains_of(std::span<const EdgeEnds> edges);

}  // namespace pardel::files
