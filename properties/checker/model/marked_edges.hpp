// MarkedEdges: the edges of a mesh that are known to be constrained before the chains of the segments are known.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "../../../core/mesh.hpp"
#include "adjacency.hpp"

namespace pardel::checker {

class MarkedEdges {
 public:
  /// The edges that the mesh lists as constrained. If it lists none: the edges that have to be constrained in a
  /// constrained Delaunay triangulation, which are those of its boundary and those that are not locally Delaunay.
  /// O(n log n) time for n edges of the mesh.
  MarkedEdges(const Mesh& mesh, const Adjacency& adjacency, StopSignal* stop = nullptr);
  /// True if the edge between a and b is marked. O(log n).
  [[nodiscard]] bool contains(Index a, Index b) const;

 private:
  void infer(const Mesh& mesh, const Adjacency& adjacency, StopSignal* stop);

  std::vector<std::pair<Index, Index>> ends_;  ///< the smaller index first; sorted
};

}  // namespace pardel::checker
