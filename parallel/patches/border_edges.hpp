// The edges between patches and the rest of a domain.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "../triangulation/triangulation.hpp"
#include "find_patches.hpp"

namespace pardel::engine {

/// An edge on the border of a patch, which lies on its left.
struct BorderEdge {
  VertexId from, to;
  std::size_t triangle;  ///< the number of the patch's triangle, among those of all patches
  unsigned side;         ///< the edge as a side of this triangle
};

/// The edges on the borders of all patches, grouped by their first vertices. Linear in their number and in the largest
/// vertex.
class BorderEdges {
 public:
  /// `border`: the vertices on the borders, in the order of the patches and of Patch::pieces().
  BorderEdges(std::span<const RegionPatch> patches, std::span<const VertexId> border);

  [[nodiscard]] std::span<const BorderEdge> all() const { return edges_; }
  /// Null if there is no such edge. Constant time: few edges have the same first vertex.
  [[nodiscard]] const BorderEdge* find(VertexId from, VertexId to) const {
    if (from + std::size_t{1} >= start_.size()) return nullptr;
    for (const BorderEdge& edge : all().subspan(start_[from], start_[from + std::size_t{1}] - start_[from]))
      if (edge.to == to) return &edge;
    return nullptr;
  }

 private:
  std::vector<BorderEdge> edges_;
  std::vector<std::size_t> start_;  ///< by first vertex
};

}  // namespace pardel::engine
