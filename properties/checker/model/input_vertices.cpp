#include "input_vertices.hpp"

#include <algorithm>

#include "../../../core/support/point_order.hpp"

namespace pardel::checker {

InputVertices::InputVertices(Array<Index> vertex, std::size_t vertices) : vertex_(std::move(vertex)) {
  input_.resize(std::max<std::size_t>(vertices, 1), no_index);
  for (std::size_t i = 0; i < vertex_.size(); ++i)
    if (vertex_[i] != no_index) input_[vertex_[i]] = static_cast<Index>(i);
}

InputVertices InputVertices::by_index(std::size_t inputs, std::size_t vertices) {
  InputVertices result;
  result.vertex_.resize(inputs, no_index);
  for (std::size_t i = 0; i < std::min(inputs, vertices); ++i) result.vertex_[i] = static_cast<Index>(i);
  return result;
}

InputVertices InputVertices::by_coordinates(std::span<const Point> inputs, std::vector<Index> wanted,
                                            std::span<const Point> vertices, const Adjacency& adjacency,
                                            StopSignal* stop) {
  Array<Index> vertex(inputs.size(), no_index);
  const auto less = [&](Index a, Index b) { return lexicographically_less(inputs[a], inputs[b]); };
  stoppable_sort(wanted.begin(), wanted.end(), less, stop);
  SparseAsk ask(stop);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    ask();
    const auto at = std::lower_bound(wanted.begin(), wanted.end(), vertices[v],
                                     [&](Index i, Point p) { return lexicographically_less(inputs[i], p); });
    if (at == wanted.end() || !(inputs[*at] == vertices[v])) continue;
    Index& match = vertex[*at];
    if (match != no_index && (adjacency.has_triangle(match) || !adjacency.has_triangle(static_cast<Index>(v))))
      continue;
    match = static_cast<Index>(v);
  }
  return {std::move(vertex), vertices.size()};
}

}  // namespace pardel::checker
