// InputVertices: the vertex of the mesh for each input point, and the input point for each vertex.
#pragma once

#include <span>
#include <vector>

#include "../../../core/mesh.hpp"
#include "adjacency.hpp"
#include "stoppable.hpp"

namespace pardel::checker {

class InputVertices {
 public:
  /// `vertex`: per input point its vertex, or no_index. `vertices`: the number of vertices of the mesh.
  InputVertices(Array<Index> vertex, std::size_t vertices);
  /// Input point i is vertex i.
  [[nodiscard]] static InputVertices by_index(std::size_t inputs, std::size_t vertices);
  /// Input points and vertices with equal coordinates correspond, of those input points that are `wanted`. If several
  /// vertices are at one place, the first vertex that has a triangle is taken. O(n log n).
  [[nodiscard]] static InputVertices by_coordinates(std::span<const Point> inputs, std::vector<Index> wanted,
                                                    std::span<const Point> vertices, const Adjacency& adjacency,
                                                    StopSignal* stop = nullptr);

  /// no_index if the input point is not a vertex.
  [[nodiscard]] Index vertex(Index input) const { return vertex_[input]; }
  /// no_index if the vertex is not an input point.
  [[nodiscard]] Index input(Index vertex) const {
    if (input_.empty()) return vertex < vertex_.size() ? vertex : no_index;
    return input_[vertex];
  }

 private:
  InputVertices() = default;

  Array<Index> vertex_;  ///< per input point
  Array<Index> input_;   ///< per vertex; empty when matched by index
};

}  // namespace pardel::checker
