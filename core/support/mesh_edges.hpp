// The edges of a mesh, as writers need them: each once, with its constraint and marker.
#pragma once

#include "../mesh.hpp"

namespace pardel {

/// The constrained edges of a mesh by their ends. O(n log n) for n constrained edges, plus O(points), to build.
/// The mesh must outlive the index.
class ConstrainedEdgeIndex {
 public:
  explicit ConstrainedEdgeIndex(const Mesh& mesh);
  /// The constrained edge with the ends a and b, in either order; null if there is none. If several have these ends,
  /// the last of them.
  [[nodiscard]] const ConstrainedEdge* find(Index a, Index b) const;

 private:
  const std::vector<ConstrainedEdge>* edges_;
  std::vector<Index> sorted_;  ///< by lower end, then higher end, then index
  Array<Index> start_;         ///< by lower end, into sorted_
};

/// One marker per point: mesh.point_markers if the mesh has them, else the first non-zero marker among the
/// constrained edges at the point, else 0.
[[nodiscard]] Array<int> vertex_markers(const Mesh& mesh);

struct MarkedEdge {
  Index a = 0;
  Index b = 0;
  int marker = 0;
};

/// The edges of a mesh, and the edge of every side: side 3t + i lies opposite corner i of triangle t.
struct EdgeTable {
  Array<MarkedEdge> edges;    ///< in the order of the triangles
  Array<Index> edge_of_side;  ///< triangles.size() * 3
};

/// The marker of an edge is its constrained edge's, else 1 where it has no second triangle, else 0. O(n log n) in
/// the constrained edges, else linear. Precondition: neighbours are right.
[[nodiscard]] EdgeTable edge_table(const Mesh& mesh);

}  // namespace pardel
