// Adjacency: the triangles of a mesh with verified neighbours, its boundary edges, and the triangles at each vertex.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "../../../core/mesh.hpp"
#include "stoppable.hpp"

namespace pardel::checker {

/// Corners i + 1 and i + 2 of a triangle are the ends of its edge i.
constexpr int next(int i) { return i == 2 ? 0 : i + 1; }
constexpr int previous(int i) { return i == 0 ? 2 : i - 1; }

/// The corner (0 to 2) at which the triangle has this vertex. Precondition: the vertex is a corner of the triangle.
inline int corner_at(const Triangle& triangle, Index vertex) {
  return triangle.v[0] == vertex ? 0 : triangle.v[1] == vertex ? 1 : 2;
}

/// Edge `edge` of a triangle. The triangle lies on the left of the edge from v[next(edge)] to v[previous(edge)].
struct TriangleEdge {
  Index triangle = no_index;
  int edge = 0;
  [[nodiscard]] bool exists() const { return triangle != no_index; }
};

struct BoundaryEdge {
  Index from, to;
  TriangleEdge left;
};

/// An edge with more than one triangle on the same side.
struct NonManifoldEdge {
  Index a, b;
  std::vector<Index> triangles;  ///< all triangles at the edge, on both sides
};

/// Sets every neighbour; uses only the corners of the triangles. If an edge has more than one triangle on a side, one
/// pair of triangles become neighbours, the others get no neighbour at this edge, and the edge is appended to
/// `non_manifold`. O(n log n).
void rebuild_neighbours(std::span<Triangle> triangles, std::vector<NonManifoldEdge>& non_manifold,
                        StopSignal* stop = nullptr);

class Adjacency {
 public:
  /// `rebuilt`: the mesh's triangles with corrected neighbours; empty if the neighbours in the mesh are correct.
  /// Preconditions: corners are distinct and in range, neighbours are reciprocal, the mesh outlives this object.
  /// Linear time, plus O(b log b) for b boundary edges.
  Adjacency(Array<Triangle> rebuilt, const Mesh& mesh, StopSignal* stop = nullptr);
  Adjacency(Adjacency&&) = default;

  [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
  /// The edges without a neighbour, sorted by (from, to).
  [[nodiscard]] std::span<const BoundaryEdge> boundary() const { return boundary_; }
  [[nodiscard]] bool on_boundary(Index vertex) const { return on_boundary_[vertex] != 0; }
  /// The number of triangles at this vertex.
  [[nodiscard]] Index corners(Index vertex) const { return corners_[vertex]; }
  [[nodiscard]] std::span<const Index> corners() const { return corners_.span(); }  ///< one number for each vertex

  /// Calls visit(triangle, corner) for the triangles around a vertex and returns the number of fans. (A fan is a
  /// sequence of triangles, counter-clockwise, each the neighbour of the one before it.) It visits every open fan, or
  /// one closed fan if no fan is open. A vertex with more fans is irregular, see index_irregular_vertices().
  template <class Visit>
  int visit_fans(Index vertex, const Visit& visit) const {
    if (start_[vertex] == no_index) return 0;
    if (!irregular_.empty() && visit_irregular(vertex, visit)) return 1;
    if (!on_boundary(vertex)) {
      visit_fan(vertex, start_[vertex], visit);
      return 1;
    }
    int fans = 0;
    auto edge = std::lower_bound(boundary_.begin(), boundary_.end(), vertex,
                                 [](const BoundaryEdge& e, Index v) { return e.from < v; });
    for (; edge != boundary_.end() && edge->from == vertex; ++edge, ++fans)
      visit_fan(vertex, edge->left.triangle, visit);
    return fans;
  }

  /// Finds the irregular vertices and lists their triangles. Afterwards visit_fans() visits all triangles of an
  /// irregular vertex, in ascending order instead of around the vertex. Linear time.
  void index_irregular_vertices(StopSignal* stop = nullptr);

  /// The triangle on the left of the edge from a to b, if there is one. Time: the degree of a.
  [[nodiscard]] TriangleEdge left_of(Index a, Index b) const;

 private:
  template <class Visit>
  void visit_fan(Index vertex, Index first, const Visit& visit) const {
    Index t = first;
    for (Index steps = 0; steps < corners_[vertex]; ++steps) {
      const Triangle& triangle = triangles_[t];
      const int corner = corner_at(triangle, vertex);
      visit(t, corner);
      t = triangle.n[next(corner)];
      if (t == no_index || t == first) return;
    }
  }

  template <class Visit>
  bool visit_irregular(Index vertex, const Visit& visit) const {
    auto entry = std::lower_bound(irregular_.begin(), irregular_.end(), std::pair(vertex, Index{0}));
    if (entry == irregular_.end() || entry->first != vertex) return false;
    for (; entry != irregular_.end() && entry->first == vertex; ++entry)
      visit(entry->second, corner_at(triangles_[entry->second], vertex));
    return true;
  }

  Array<Triangle> rebuilt_;
  std::span<const Triangle> triangles_;
  std::vector<BoundaryEdge> boundary_;
  Array<Index> start_;  ///< per vertex, one of its triangles
  Array<Index> corners_;
  Array<char> on_boundary_;
  std::vector<std::pair<Index, Index>> irregular_;  ///< (vertex, triangle), sorted
};

}  // namespace pardel::checker
