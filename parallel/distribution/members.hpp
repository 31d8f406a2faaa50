// The triangles and vertices of a piece, among those that the rank holds.
#pragma once

#include <atomic>
#include <vector>

#include "../concurrency/threads.hpp"
#include "distribution.hpp"

namespace pardel::engine {

/// What belongs to the piece of a rank, and lists of triangles and vertices that need a closer look.
class Members {
 public:
  /// `inputs`: the vertices below this one are the points of the input.
  Members(const Triangulation& t, std::size_t inputs, const Distribution& distribution, const Threads& threads);

  /// The slots with triangles of the piece are in use.
  [[nodiscard]] const IndexAllocator& triangles() const { return triangles_; }
  /// The vertices of the piece are in use: the corners of its triangles, and points of the input that are in no
  /// triangle.
  [[nodiscard]] const IndexAllocator& vertices() const { return vertices_; }
  // The same in constant time, until forget_vertices():
  [[nodiscard]] bool has_vertex(VertexId v) const { return (vertex_[v] & in_piece) != 0; }
  /// True if the vertex exists in the mesh and lies in a cell that the rank owns.
  [[nodiscard]] bool owns_vertex(VertexId v) const { return (vertex_[v] & (exists | at_home)) == (exists | at_home); }
  void forget_vertices() { vertex_ = {}; }

  /// The triangles of the piece with a corner that the rank does not own.
  [[nodiscard]] const std::vector<TriangleId>& at_border() const { return at_border_; }
  /// The triangles that the rank holds, but that belong to other pieces.
  [[nodiscard]] const std::vector<TriangleId>& of_others() const { return of_others_; }
  /// The vertices of the piece that the rank does not own.
  [[nodiscard]] const std::vector<VertexId>& not_owned() const { return not_owned_; }
  /// The constrained sides of all triangles that the rank holds.
  [[nodiscard]] const std::vector<EdgeRef>& constrained_sides() const { return constrained_sides_; }

 private:
  static constexpr char exists = 1, in_piece = 2, at_home = 4;

  void find_home(const Triangulation& t, const Distribution& distribution, const Threads& threads);
  void classify_triangles(const Triangulation& t, const Distribution& distribution, const Threads& threads);
  void list_vertices(const Threads& threads);
  [[nodiscard]] char marks_of(VertexId v) { return std::atomic_ref<char>(vertex_[v]).load(std::memory_order_relaxed); }
  void mark(VertexId v, char marks) {
    if ((marks_of(v) & marks) != marks) std::atomic_ref<char>(vertex_[v]).fetch_or(marks, std::memory_order_relaxed);
  }

  Array<char> vertex_;  ///< marks
  IndexAllocator triangles_, vertices_;
  std::vector<TriangleId> at_border_, of_others_;
  std::vector<VertexId> not_owned_;
  std::vector<EdgeRef> constrained_sides_;
};

}  // namespace pardel::engine
