// Numbering: the numbers by which findings name the vertices, triangles and listed edges of a mesh. If the mesh is a
// part of a larger one, they are those of the whole.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "../witness.hpp"
#include "adjacency.hpp"

namespace pardel::checker {

/// The number of a vertex, of a triangle, and of a point, segment, hole or region of the domain, in a sentence.
/// Parameters: indices in the whole mesh and in the domain.
[[nodiscard]] inline Witness vertex_number(std::uint64_t v) { return {Numbered::vertex, static_cast<Index>(v)}; }
[[nodiscard]] inline Witness triangle_number(std::uint64_t t) { return {Numbered::triangle, static_cast<Index>(t)}; }
[[nodiscard]] inline Witness domain_number(std::uint64_t i) { return {Numbered::of_domain, static_cast<Index>(i)}; }
/// "a-b": the edge between two vertices.
[[nodiscard]] inline Witness edge_text(std::uint64_t a, std::uint64_t b) {
  return vertex_number(a) + "-" + vertex_number(b);
}

/// By default, the numbers are the indices.
struct Numbering {
  /// Per vertex; each is less than no_index. Empty: the indices.
  std::span<const std::uint64_t> vertices{};
  std::span<const Index> triangles{};  ///< per triangle. Empty: the indices plus `first_triangle`.
  Index first_triangle = 0;
  Index first_listed_edge = 0;
  /// Sides of triangles whose neighbour belongs to another part, and has a smaller number. Sorted.
  std::span<const std::pair<Index, int>> earlier_neighbours{};

  [[nodiscard]] Index vertex(Index v) const { return vertices.empty() ? v : static_cast<Index>(vertices[v]); }
  [[nodiscard]] Index triangle(Index t) const { return triangles.empty() ? t + first_triangle : triangles[t]; }
  [[nodiscard]] Index listed_edge(Index e) const { return e + first_listed_edge; }
  [[nodiscard]] Witness edge_text(Index a, Index b) const { return checker::edge_text(vertex(a), vertex(b)); }
  [[nodiscard]] std::vector<Index> triangle_and_corners(Index t, const Triangle& triangle) const {
    return {this->triangle(t), vertex(triangle.v[0]), vertex(triangle.v[1]), vertex(triangle.v[2])};
  }
  [[nodiscard]] bool has_earlier_neighbour(Index t, int side) const {
    return std::ranges::binary_search(earlier_neighbours, std::pair(t, side));
  }
};

}  // namespace pardel::checker
