// Lists each edge of a mesh once, with its marker, and finds constrained edges by their ends.
#pragma once

#include <span>

#include "../mesh.hpp"

namespace pardel {

/// Finds constrained edges of a mesh by their ends. Construction takes O(n log n + points) for n constrained edges, a
/// search O(log k) for k constrained edges at the lower end. The mesh must outlive the index.
class ConstrainedEdgeIndex {
 public:
  explicit ConstrainedEdgeIndex(const Mesh& mesh);
  /// Returns the constrained edge with the ends a and b, in either order; null if there is none. If several edges have
  /// these ends, returns the last one.
  [[nodiscard]] const ConstrainedEdge* find(Index a, Index b) const;

 private:
  const std::vector<ConstrainedEdge>* edges_;
  std::vector<Index> sorted_;  ///< by lower end, then higher end, then index
  Array<Index> start_;         ///< start_[v]: the first place in sorted_ with lower end v
};

/// One marker per point: mesh.point_markers if the mesh has them, else the first non-zero marker of a constrained edge
/// at the point, else 0. `inferred` holds markers that the mesh does not have; it has to outlive the result.
[[nodiscard]] std::span<const int> vertex_markers(const Mesh& mesh, Array<int>& inferred);

struct MarkedEdge {
  Index a = 0;
  Index b = 0;
  int marker = 0;
};

/// The edges of a mesh, and the edge of every side. Side 3t + i is opposite corner i of triangle t.
struct EdgeTable {
  Array<MarkedEdge> edges;    ///< in the order in which the triangles have them
  Array<Index> edge_of_side;  ///< triangles.size() * 3
};

/// Returns all edges. The marker of an edge is that of its constrained edge; else 1 if the edge has only one triangle;
/// else 0. Time O(n log n) for n constrained edges, linear in triangles and points. Precondition: Triangle::n is
/// correct.
[[nodiscard]] EdgeTable edge_table(const Mesh& mesh);

}  // namespace pardel
