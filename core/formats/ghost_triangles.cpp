#include "ghost_triangles.hpp"

#include <algorithm>
#include <utility>

#include "../support/exchange_lists.hpp"

namespace pardel::files {

RanksOfPoints::RanksOfPoints(const PieceOfMesh& piece) : is_shared_(Array<char>::zeroes(piece.mesh.points.size())) {
  std::vector<std::pair<Index, int>> pairs;
  for (const SharedVertices& shared : piece.shared)
    for (const Index v : shared.vertices) pairs.emplace_back(v, shared.rank);
  std::ranges::sort(pairs);
  for (const auto& [v, rank] : pairs) {
    if (points_.empty() || points_.back() != v) {
      points_.push_back(v);
      start_.push_back(ranks_.size());
      is_shared_[v] = 1;
    }
    ranks_.push_back(rank);
  }
  start_.push_back(ranks_.size());
}

std::span<const int> RanksOfPoints::operator[](Index point) const {
  if (is_shared_[point] == 0) return {};
  const auto i = static_cast<std::size_t>(std::ranges::lower_bound(points_, point) - points_.begin());
  return std::span<const int>(ranks_).subspan(start_[i], start_[i + 1] - start_[i]);
}

std::vector<std::vector<GhostTriangle>> ghost_triangles(const PieceOfMesh& piece, const RanksOfPoints& ranks_of_points,
                                                        std::uint64_t first_triangle, Ranks& ranks) {
  const Mesh& mesh = piece.mesh;
  std::vector<std::vector<GhostTriangle>> leaving(static_cast<std::size_t>(ranks.count()));
  std::vector<int> receivers;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t].v;
    receivers.clear();
    for (const Index corner : v)
      for (const int rank : ranks_of_points[corner])
        if (std::ranges::find(receivers, rank) == receivers.end()) receivers.push_back(rank);
    for (const int rank : receivers)
      leaving[static_cast<std::size_t>(rank)].push_back({first_triangle + t,
                                                         {piece.number[v[0]], piece.number[v[1]], piece.number[v[2]]},
                                                         {mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]}});
  }
  return exchange_lists(std::move(leaving), ranks);
}

}  // namespace pardel::files
