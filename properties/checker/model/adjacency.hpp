// Adjacency: the triangles of a mesh with verified neighbours, its boundary edges, and the triangles at each vertex.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "../../../core/mesh.hpp"
#include "../arithmetic/exact_sum.hpp"
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

/// Sorts edges by (from, to), and equal ones by their triangle.
void sort_boundary(std::vector<BoundaryEdge>& boundary, StopSignal* stop = nullptr);

/// Sets every neighbour; uses only the corners of the triangles. If an edge has more than one triangle on a side, one
/// pair of triangles become neighbours, the others get no neighbour at this edge, and the edge is appended to
/// `non_manifold`. O(n log n).
void rebuild_neighbours(std::span<Triangle> triangles, std::vector<NonManifoldEdge>& non_manifold,
                        StopSignal* stop = nullptr);

class Adjacency {
 public:
  /// `start`: per vertex one of its triangles, or no_index. `boundary`: the edges without a neighbour, sorted.
  /// Preconditions: corners are distinct and in range, neighbours are reciprocal, the triangles outlive this object.
  Adjacency(std::span<const Triangle> triangles, Array<Index> start, std::vector<BoundaryEdge> boundary);
  /// The same, for triangles that the object keeps.
  Adjacency(Array<Triangle> rebuilt, Array<Index> start, std::vector<BoundaryEdge> boundary);
  Adjacency(Adjacency&&) = default;

  [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
  /// The edges without a neighbour, sorted by (from, to).
  [[nodiscard]] std::span<const BoundaryEdge> boundary() const { return boundary_; }
  [[nodiscard]] bool on_boundary(Index vertex) const { return on_boundary_[vertex] != 0; }
  [[nodiscard]] bool has_triangle(Index vertex) const { return start_[vertex] != no_index; }
  /// Counts the triangles at each vertex, for corners(). The walk around a vertex then begins in its last triangle, so
  /// that the number of triangles that it reaches does not depend on the number of threads. Linear time.
  void count_corners(StopSignal* stop = nullptr);
  /// The number of triangles at this vertex. Precondition: count_corners() was called.
  [[nodiscard]] Index corners(Index vertex) const { return corners_[vertex]; }

  /// Calls visit(triangle, corner) for the triangles around a vertex and returns the number of fans. (A fan is a
  /// sequence of triangles, counter-clockwise, each the neighbour of the one before it.) It visits every open fan, or
  /// one closed fan if no fan is open. A vertex with more fans is irregular, see index_irregular_vertices().
  /// If visit() returns a bool, false ends the visits.
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
      if (!visit_fan(vertex, edge->left.triangle, visit)) break;
    return fans;
  }

  /// Finds the irregular vertices and lists their triangles. Afterwards visit_fans() visits all triangles of an
  /// irregular vertex, in ascending order instead of around the vertex. Precondition: count_corners() was called.
  /// Linear time.
  void index_irregular_vertices(StopSignal* stop = nullptr);

  /// True if visit_fans() finds fewer triangles at a than at b. Time: the smaller of the two numbers.
  [[nodiscard]] bool has_fewer_triangles(Index a, Index b) const;

  /// The triangle on the left of the edge from a to b, if there is one. Time: the degree of a.
  [[nodiscard]] TriangleEdge left_of(Index a, Index b) const;

 private:
  /// Calls visit(), which may return nothing. False if it returns false.
  template <class Visit>
  static bool goes_on(const Visit& visit, Index t, int corner) {
    if constexpr (std::is_void_v<std::invoke_result_t<Visit, Index, int>>) {
      visit(t, corner);
      return true;
    } else {
      return visit(t, corner);
    }
  }

  template <class Visit>
  bool visit_fan(Index vertex, Index first, const Visit& visit) const {
    // Neighbours are reciprocal, so the walk ends at a boundary edge or returns to its first triangle.
    Index t = first;
    for (std::size_t steps = 0; steps < triangles_.size(); ++steps) {
      const Triangle& triangle = triangles_[t];
      const int corner = corner_at(triangle, vertex);
      if (!goes_on(visit, t, corner)) return false;
      t = triangle.n[next(corner)];
      if (t == no_index || t == first) break;
    }
    return true;
  }

  template <class Visit>
  bool visit_irregular(Index vertex, const Visit& visit) const {
    auto entry = std::lower_bound(irregular_.begin(), irregular_.end(), std::pair(vertex, Index{0}));
    if (entry == irregular_.end() || entry->first != vertex) return false;
    for (; entry != irregular_.end() && entry->first == vertex; ++entry)
      if (!goes_on(visit, entry->second, corner_at(triangles_[entry->second], vertex))) break;
    return true;
  }
  [[nodiscard]] Index count_up_to(Index vertex, Index most) const;

  Array<Triangle> rebuilt_;
  std::span<const Triangle> triangles_;
  std::vector<BoundaryEdge> boundary_;
  Array<Index> start_;    ///< per vertex, one of its triangles
  Array<Index> corners_;  ///< per vertex; empty before count_corners()
  Array<char> on_boundary_;
  std::vector<std::pair<Index, Index>> irregular_;  ///< (vertex, triangle), sorted
};

/// The vertices with boundary edges, ascending.
[[nodiscard]] std::vector<Index> boundary_vertices(const Adjacency& adjacency);

/// How many of the first `vertices` vertices have triangles.
[[nodiscard]] std::uint64_t count_used_vertices(const Adjacency& adjacency, std::size_t vertices, StopSignal* stop);

/// Twice the exact sum of the areas of all triangles. In the sum of a x b over the edges of all triangles, the two
/// directions of an edge cancel exactly; the boundary remains.
[[nodiscard]] ExactSum covered_area(std::span<const Point> points, const Adjacency& adjacency);

}  // namespace pardel::checker
