// The triangles and vertices of a piece, among those that the rank holds.
#pragma once

#include <vector>

#include "../../parallel/threads/threads.hpp"
#include "distribution.hpp"

namespace pardel::engine {

/// What belongs to the piece of a rank, and lists of triangles and vertices that need a closer look.
class Members {
 public:
  Members(const Triangulation& t, const Distribution& distribution, const Threads& threads);

  /// The slots with triangles of the piece are in use.
  [[nodiscard]] const IndexAllocator& triangles() const { return triangles_; }
  /// The vertices of the piece are in use: the corners of its triangles, and points of the input that are in no
  /// triangle.
  [[nodiscard]] const IndexAllocator& vertices() const { return vertices_; }
  // The same in constant time, until forget_vertices():
  [[nodiscard]] bool has_vertex(VertexId v) const { return (vertex_[v] & in_piece) != 0; }
  /// True if the vertex exists in the mesh and lies in a cell that the rank owns.
  [[nodiscard]] bool owns_vertex(VertexId v) const { return (vertex_[v] & owned) != 0; }
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
  static constexpr char in_piece = 1, owned = 2;

  void mark_owned(const Triangulation& t, const Distribution& distribution);
  void classify_triangles(const Triangulation& t, const Distribution& distribution, const Threads& threads);
  void correct_marks_at_border(const Triangulation& t, const Subdomain& part);
  void list_vertices(const Threads& threads);
  void mark_corners(const Slot& slot) {
    for (const VertexId v : slot.v) vertex_[v] |= in_piece;
  }
  [[nodiscard]] bool owns_all_corners(const Slot& slot) const {
    return (vertex_[slot.v[0]] & vertex_[slot.v[1]] & vertex_[slot.v[2]] & owned) != 0;
  }

  Array<char> vertex_;  ///< marks
  IndexAllocator triangles_, vertices_;
  std::vector<TriangleId> at_border_, of_others_;
  std::vector<VertexId> not_owned_;
  std::vector<EdgeRef> constrained_sides_;
};

}  // namespace pardel::engine
