#include "border_edges.hpp"

#include <algorithm>
#include <numeric>

namespace pardel::engine {

BorderEdges::BorderEdges(std::span<const RegionPatch> patches, std::span<const VertexId> border) {
  if (border.empty()) return;
  std::vector<BorderEdge> unordered;
  std::size_t points = 0, triangles = 0;
  for (const auto& [region, patch] : patches) {
    for (const BorderSide& side : patch.border())
      unordered.push_back({border[points + side.from], border[points + side.to], triangles + side.triangle, side.side});
    points += patch.border_points();
    triangles += patch.triangles();
  }
  // A counting sort. start_[v + 1] counts the edges from v; then it is the place of the next one; at the end, the place
  // after the last one, which is where the edges from v + 1 start.
  start_.resize(std::size_t{*std::ranges::max_element(border)} + 2, 0);
  for (const BorderEdge& edge : unordered) ++start_[edge.from + std::size_t{1}];
  std::exclusive_scan(start_.begin() + 1, start_.end(), start_.begin() + 1, std::size_t{0});
  edges_.resize(unordered.size());
  for (const BorderEdge& edge : unordered) edges_[start_[edge.from + std::size_t{1}]++] = edge;
}

}  // namespace pardel::engine
