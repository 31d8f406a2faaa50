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

  /// Precondition: the corners are below `points`. O(points + triangles).
  HalfEdges(std::span<const Corners> triangles, std::size_t points) : start_(points + 1, 0) {
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
  /// The first side from one vertex to another; no_index if there is none.
  [[nodiscard]] Index find(Index from_vertex, Index to) const {
    for (const Out& out : from(from_vertex))
      if (out.to == to) return out.side;
    return no_index;
  }

 private:
  std::vector<Index> start_;
  std::vector<Out> out_;
};

}  // namespace pardel::engine
