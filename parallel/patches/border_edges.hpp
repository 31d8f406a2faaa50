// The edges between patches and the rest of a domain.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "../triangulation/triangulation.hpp"
#include "find_patches.hpp"

namespace pardel::engine {

/// An edge on the border of a patch, which lies on its left.
struct BorderEdge {
  VertexId from, to;
  std::size_t triangle;  ///< the number of the patch's triangle, among those of all patches
  unsigned side;         ///< the edge as a side of this triangle
  [[nodiscard]] std::pair<VertexId, VertexId> ends() const { return {from, to}; }
};

/// The edges on the borders of all patches, in ascending order of their ends. `border`: the vertices on the borders, in
/// the order of the patches and of Patch::pieces().
[[nodiscard]] std::vector<BorderEdge> border_edges(std::span<const RegionPatch> patches,
                                                   std::span<const VertexId> border);

}  // namespace pardel::engine
