#include "border_edges.hpp"

#include <algorithm>

namespace pardel::engine {

std::vector<BorderEdge> border_edges(std::span<const RegionPatch> patches, std::span<const VertexId> border) {
  std::vector<BorderEdge> edges;
  std::size_t points = 0, triangles = 0;
  for (const auto& [region, patch] : patches) {
    for (const BorderSide& side : patch.border())
      edges.push_back({border[points + side.from], border[points + side.to], triangles + side.triangle, side.side});
    points += patch.border_points();
    triangles += patch.triangles();
  }
  std::ranges::sort(edges, {}, &BorderEdge::ends);
  return edges;
}

}  // namespace pardel::engine
