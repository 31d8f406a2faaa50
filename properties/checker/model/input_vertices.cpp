#include "input_vertices.hpp"

#include <algorithm>
#include <numeric>

#include "../../../core/support/point_order.hpp"

namespace pardel::checker {

InputVertices InputVertices::by_index(std::size_t inputs, std::size_t vertices) {
  InputVertices result;
  result.vertex_.resize(inputs, no_index);
  for (std::size_t i = 0; i < std::min(inputs, vertices); ++i) result.vertex_[i] = static_cast<Index>(i);
  return result;
}

InputVertices InputVertices::by_coordinates(std::span<const Point> inputs, std::span<const Point> vertices,
                                            const Adjacency& adjacency, StopSignal* stop) {
  InputVertices result;
  result.vertex_.resize(inputs.size(), no_index);
  result.input_.resize(std::max<std::size_t>(vertices.size(), 1), no_index);
  std::vector<Index> sorted(inputs.size());
  std::iota(sorted.begin(), sorted.end(), Index{0});
  const auto less = [&](Index a, Index b) { return lexicographically_less(inputs[a], inputs[b]); };
  stoppable_sort(sorted.begin(), sorted.end(), less, stop);
  SparseAsk ask(stop);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    ask();
    const auto at = std::lower_bound(sorted.begin(), sorted.end(), vertices[v],
                                     [&](Index i, Point p) { return lexicographically_less(inputs[i], p); });
    if (at == sorted.end() || !(inputs[*at] == vertices[v])) continue;
    Index& match = result.vertex_[*at];
    if (match != no_index && (adjacency.has_triangle(match) || !adjacency.has_triangle(static_cast<Index>(v))))
      continue;
    match = static_cast<Index>(v);
  }
  for (std::size_t i = 0; i < inputs.size(); ++i)
    if (result.vertex_[i] != no_index) result.input_[result.vertex_[i]] = static_cast<Index>(i);
  return result;
}

}  // namespace pardel::checker
