// The triangles and vertices of a piece, among those that the rank holds.
#pragma once

#include <atomic>
#include <utility>
#include <vector>

#include "../concurrency/threads.hpp"
#include "distribution.hpp"

namespace pardel::engine {

/// Marks per vertex and per slot of a triangulation, and lists of triangles that need a closer look.
class Members {
 public:
  /// `inputs`: the vertices below this one are the points of the input.
  Members(const Triangulation& t, std::size_t inputs, const Distribution& distribution, const Threads& threads);

  /// True if the triangle belongs to the piece. Also defined for unused slots: false.
  [[nodiscard]] bool has_triangle(TriangleId id) const { return triangle_[id] != 0; }
  /// True if the vertex is a corner of a triangle of the piece, or a point of the input that is in no triangle.
  [[nodiscard]] bool has_vertex(VertexId v) const { return (vertex_[v] & in_piece) != 0; }
  /// True if the vertex exists in the mesh and lies in a cell that the rank owns.
  [[nodiscard]] bool owns_vertex(VertexId v) const { return (vertex_[v] & (exists | at_home)) == (exists | at_home); }
  /// The cells in which the vertices lie; only once.
  [[nodiscard]] Array<Index> take_cells() { return std::move(cell_); }

  /// The triangles with a corner that the rank does not own.
  [[nodiscard]] const std::vector<TriangleId>& at_border() const { return at_border_; }
  /// The constrained sides of all triangles that the rank holds.
  [[nodiscard]] const std::vector<EdgeRef>& constrained_sides() const { return constrained_sides_; }

 private:
  static constexpr char exists = 1, in_piece = 2, at_home = 4;

  void classify_vertices(const Triangulation& t, const Distribution& distribution, const Threads& threads);
  void classify_triangles(const Triangulation& t, const Distribution& distribution, const Threads& threads);
  [[nodiscard]] char marks_of(VertexId v) { return std::atomic_ref<char>(vertex_[v]).load(std::memory_order_relaxed); }
  void mark(VertexId v, char marks) {
    if ((marks_of(v) & marks) != marks) std::atomic_ref<char>(vertex_[v]).fetch_or(marks, std::memory_order_relaxed);
  }

  Array<Index> cell_;
  Array<char> vertex_, triangle_;
  std::vector<TriangleId> at_border_;
  std::vector<EdgeRef> constrained_sides_;
};

}  // namespace pardel::engine
