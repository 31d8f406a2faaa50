// The directed sides of a list of triangles, by the vertex where they start.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "../../core/pslg.hpp"

namespace pardel::engine {

/// Side i of a triangle lies opposite corner i, as in Mesh. Its number is 3 * triangle + i.
class HalfEdges {
 public:
  using Corners = std::array<Index, 3>;

  /// Precondition: the corners are below `points`. O(points + triangles). The triangles have to outlive the object.
  HalfEdges(std::span<const Corners> triangles, std::size_t points) : triangles_(triangles), start_(points + 1, 0) {
    for (const Corners& v : triangles)
      for (const Index from : v) ++start_[from + 1];
    for (std::size_t v = 0; v < points; ++v) start_[v + 1] += start_[v];
    out_.resize(3 * triangles.size());
    std::vector<Index> next(start_.begin(), start_.end() - 1);
    for (Index t = 0; t < triangles.size(); ++t)
      for (Index i = 0; i < 3; ++i) {
        const Index from = triangles[t][(i + 1) % 3], to = triangles[t][(i + 2) % 3];
        out_[next[from]++] = {to, 3 * t + i};
      }
  }

  struct Out {
    Index to, side;
  };
  /// The sides that start at a vertex, in ascending order of their numbers.
  [[nodiscard]] std::span<const Out> from(Index vertex) const {
    return {out_.data() + start_[vertex], out_.data() + start_[vertex + 1]};
  }
  /// Calls visit(side) for each side from one vertex to another, until it returns true. O(d), where d is the number of
  /// sides at the vertex that has fewer of them.
  template <class Visit>
  void for_each_side(Index from_vertex, Index to, const Visit& visit) const {
    if (from(from_vertex).size() <= from(to).size()) {
      for (const Out& out : from(from_vertex))
        if (out.to == to && visit(out.side)) return;
      return;
    }
    // Of the triangle that a side leaves `to` in, the side that enters `to`.
    for (const Out& out : from(to)) {
      const Index t = out.side / 3, i = out.side % 3;
      if (triangles_[t][i] == from_vertex && visit(3 * t + (i + 2) % 3)) return;
    }
  }
  /// A side from one vertex to another, the only one in a triangulation; no_index if there is none.
  [[nodiscard]] Index find(Index from_vertex, Index to) const {
    Index found = no_index;
    for_each_side(from_vertex, to, [&](Index side) {
      found = side;
      return true;
    });
    return found;
  }

 private:
  std::span<const Corners> triangles_;
  std::vector<Index> start_;
  std::vector<Out> out_;
};

}  // namespace pardel::engine
