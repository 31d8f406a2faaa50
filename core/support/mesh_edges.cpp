#include "mesh_edges.hpp"

#include <algorithm>
#include <numeric>

namespace pardel {
namespace {

std::pair<Index, Index> ends(const ConstrainedEdge& e) { return std::minmax(e.a, e.b); }

}  // namespace

ConstrainedEdgeIndex::ConstrainedEdgeIndex(const Mesh& mesh)
    : edges_(&mesh.constrained_edges), sorted_(mesh.constrained_edges.size()), start_(mesh.points.size() + 1, 0) {
  std::iota(sorted_.begin(), sorted_.end(), Index{0});
  const auto key = [&](Index i) { return std::pair(ends((*edges_)[i]), i); };
  std::sort(sorted_.begin(), sorted_.end(), [&](Index i, Index j) { return key(i) < key(j); });
  for (const ConstrainedEdge& e : *edges_) ++start_[ends(e).first + 1];
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
}

const ConstrainedEdge* ConstrainedEdgeIndex::find(Index a, Index b) const {
  const auto [low, high] = std::minmax(a, b);
  const auto first = sorted_.begin() + start_[low];
  const auto last = sorted_.begin() + start_[low + 1];
  const auto beyond =
      std::upper_bound(first, last, high, [&](Index end, Index i) { return end < ends((*edges_)[i]).second; });
  if (beyond == first || ends((*edges_)[*(beyond - 1)]).second != high) return nullptr;
  return &(*edges_)[*(beyond - 1)];
}

std::span<const int> vertex_markers(const Mesh& mesh, Array<int>& inferred) {
  if (!mesh.point_markers.empty()) return mesh.point_markers.span();
  inferred = Array<int>::zeroes(mesh.points.size());
  for (const ConstrainedEdge& e : mesh.constrained_edges) {
    for (const Index end : {e.a, e.b}) {
      if (inferred[end] == 0) inferred[end] = e.marker;
    }
  }
  return inferred.span();
}

EdgeTable edge_table(const Mesh& mesh) {
  const ConstrainedEdgeIndex constrained(mesh);
  EdgeTable table;
  table.edge_of_side.resize(3 * mesh.triangles.size(), no_index);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const Index neighbour = triangle.n[i];
      if (neighbour != no_index && neighbour < t) continue;
      const auto edge = static_cast<Index>(table.edges.size());
      const Index a = triangle.v[(i + 1) % 3];
      const Index b = triangle.v[(i + 2) % 3];
      const ConstrainedEdge* constraint = constrained.find(a, b);
      const int marker = constraint != nullptr ? constraint->marker : neighbour == no_index ? 1 : 0;
      table.edges.push_back({a, b, marker});
      table.edge_of_side[3 * t + i] = edge;
      if (neighbour == no_index) continue;
      const Triangle& back = mesh.triangles[neighbour];
      for (std::size_t j = 0; j < 3; ++j) {
        if (std::minmax(back.v[(j + 1) % 3], back.v[(j + 2) % 3]) == std::minmax(a, b)) {
          table.edge_of_side[3 * std::size_t{neighbour} + j] = edge;
        }
      }
    }
  }
  return table;
}

}  // namespace pardel
