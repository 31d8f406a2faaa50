// MarkedEdges: the edges of a mesh that are known to be constrained before the chains of the segments are known.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "../../../core/mesh.hpp"
#include "adjacency.hpp"
#include "scan.hpp"

namespace pardel::checker {

class MarkedEdges {
 public:
  /// The edges that the mesh lists as constrained. If it lists none: the edges that have to be constrained in a
  /// constrained Delaunay triangulation, which are those of its boundary and those that are not locally Delaunay.
  /// `scan` is the scan of the triangles of `adjacency`. O(n log n) time for n listed edges, or for n edges of the
  /// boundary and open tests of the scan.
  MarkedEdges(const Mesh& mesh, const Adjacency& adjacency, const Scan& scan, StopSignal* stop = nullptr);
  /// True if the edge between a and b is marked. O(log n).
  [[nodiscard]] bool contains(Index a, Index b) const;

 private:
  void infer(const Mesh& mesh, const Adjacency& adjacency, const Scan& scan, StopSignal* stop);

  std::vector<std::pair<Index, Index>> ends_;  ///< the smaller index first; sorted
};

}  // namespace pardel::checker
