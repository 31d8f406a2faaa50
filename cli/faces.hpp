// The faces between walls of a mesh.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"

namespace pardel::cli {

/// Undirected edges, sorted by ends.
struct EdgeSet {
  std::vector<Segment> edges;

  /// Sorts the edges. If several edges have the same ends, only the first one stays.
  void finish();
  /// Precondition: finish() was called last.
  [[nodiscard]] bool contains(Index a, Index b) const;
};

/// The edges with their markers, not yet sorted.
[[nodiscard]] EdgeSet to_edge_set(const std::vector<ConstrainedEdge>& edges);

struct EndsOfSide {
  Index from, to;
};
/// The side opposite corner i; the triangle lies to its left.
[[nodiscard]] inline EndsOfSide side(const Triangle& t, int i) { return {t.v[(i + 1) % 3], t.v[(i + 2) % 3]}; }

/// The face of each triangle, as a number from 0 on. Two triangles are in the same face if a path connects them without
/// crossing an edge of `walls`.
[[nodiscard]] std::vector<Index> faces(const Mesh& mesh, const EdgeSet& walls);

/// True for each of `count` faces that reaches the boundary of the mesh where there is no wall.
[[nodiscard]] std::vector<char> open_faces(const Mesh& mesh, const EdgeSet& walls, const std::vector<Index>& face,
                                           std::size_t count);

/// The largest triangle of every face. Its centroid is inside the face in spite of rounding.
[[nodiscard]] std::vector<Index> largest(const Mesh& mesh, const std::vector<Index>& face);

}  // namespace pardel::cli
