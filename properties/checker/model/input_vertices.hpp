// Which vertex of the mesh is which input point.
#pragma once

#include <span>

#include "../../../core/mesh.hpp"

namespace pardel::checker {

class InputVertices {
 public:
  /// By index: input point i is vertex i. By coordinates, where the mesh numbers its vertices in its own way.
  [[nodiscard]] static InputVertices by_index(std::size_t inputs, std::size_t vertices);
  /// Of several vertices at one place the first that is used by a triangle is taken.
  [[nodiscard]] static InputVertices by_coordinates(std::span<const Point> inputs, std::span<const Point> vertices,
                                                    std::span<const Index> corners_of_vertex);

  /// no_index: the input point is no vertex.
  [[nodiscard]] Index vertex(Index input) const { return vertex_[input]; }
  /// no_index: the vertex is no input point.
  [[nodiscard]] Index input(Index vertex) const {
    if (input_.empty()) return vertex < vertex_.size() ? vertex : no_index;
    return input_[vertex];
  }

 private:
  Array<Index> vertex_;  ///< per input point
  Array<Index> input_;   ///< per vertex; empty when matched by index
};

}  // namespace pardel::checker
