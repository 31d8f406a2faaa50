// The part of a triangulation that one rank holds, and how parts of it travel to other ranks.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "../../core/support/message.hpp"
#include "../../parallel/threads/index_allocator.hpp"
#include "../../parallel/triangulation/triangulation.hpp"
#include "held_segments.hpp"
#include "names.hpp"

namespace pardel::engine {

/// Triangles of one rank, with names that other ranks understand. At the border of the part, triangles have the
/// neighbour `beyond` (triangulation/held.hpp).
class Subdomain {
 public:
  /// What all ranks have in common: vertices and slots with the same indices, from 0 on.
  struct Common {
    Index vertices, triangles;
  };
  [[nodiscard]] const Common& common() const { return common_; }
  /// The allocators are those of t; new indices are taken from them. Common indices are named after everyone, others
  /// after `self`. `segments`: those of t, or nullptr if all ranks have all segments.
  Subdomain(Triangulation& t, IndexAllocator& vertices, IndexAllocator& triangles, std::uint32_t self, Common common,
            HeldSegments* segments = nullptr);
  [[nodiscard]] const HeldSegments* segments() const { return segments_; }

  /// True if the slot contains a triangle of the part. Precondition: no phase runs.
  [[nodiscard]] bool holds(TriangleId id) const { return t_.slots[id].v[0] != no_corner_; }
  /// The same for any slot: false if it is not in use.
  [[nodiscard]] bool has(TriangleId id) const { return triangles_->uses(id) && holds(id); }
  /// Calls visit(id) for all triangles of the part. Precondition: no phase runs.
  template <class Visit>
  void for_each_triangle(const Visit& visit) const {
    for_each_triangle(0, triangles_->end(), visit);
  }
  /// The same for the slots from `first` to `last` - 1.
  template <class Visit>
  void for_each_triangle(TriangleId first, TriangleId last, const Visit& visit) const;
  /// True if another rank may know the name of the slot.
  [[nodiscard]] bool is_known_elsewhere(TriangleId id) const {
    return id < common_.triangles || is_known_elsewhere_.get(id);
  }
  /// Calls visit(begin, end, may_be_known) for runs of slots, from `first` to `last` - 1. If `may_be_known` is false,
  /// is_known_elsewhere() is false for the whole run.
  template <class Visit>
  void for_each_run(TriangleId first, TriangleId last, const Visit& visit) const {
    is_known_elsewhere_.for_each_run(first, last, [&](TriangleId begin, TriangleId end, bool may_be_set) {
      visit(begin, end, may_be_set || begin < common_.triangles);
    });
  }
  /// True if the triangle across the side is not held. False on the boundary of the domain.
  [[nodiscard]] bool is_beyond(EdgeRef across) const { return !across.none() && across.triangle() == beyond_; }
  [[nodiscard]] Name name_of(TriangleId id) const { return triangle_names_.of(id); }
  [[nodiscard]] Name name_of_vertex(VertexId v) const { return vertex_names_.of(v); }
  /// The vertices that other ranks have named.
  [[nodiscard]] const std::vector<VertexId>& vertices_of_others() const { return vertices_of_others_; }
  /// no_index if the rank does not hold it.
  [[nodiscard]] TriangleId triangle(Name name) const { return triangle_names_.index_of(name); }
  [[nodiscard]] VertexId vertex(Name name) const { return vertex_names_.index_of(name); }

  /// To be called before the allocators are destroyed. Afterwards the part does not change.
  void finish() {
    final_triangles_ = *triangles_;
    triangles_ = &*final_triangles_;
  }

  // For what does not come from write() and read():
  /// Another rank has named the vertex.
  void name_vertex(VertexId v, Name name) {
    vertex_names_.bind(name, v);
    vertices_of_others_.push_back(v);
  }
  /// A point of the input that another rank has named, and that is in no triangle.
  struct LoosePoint {
    Name name;
    Point at;
  };
  void add(std::span<const LoosePoint> loose);
  /// Another rank has named the slot of the triangle.
  void name_triangle(TriangleId id, Name name) {
    triangle_names_.bind(name, id);
    is_known_elsewhere_.set(id, 1);
  }
  /// The triangle across the side is not held.
  void cut(EdgeRef side) { t_.slots[side.triangle()].n[side.side()] = beyond(side.constrained()); }
  /// Links triangles that are held and have a side in common, but do not know it: a sender names a neighbour only if it
  /// holds it, too.
  void sew();

  /// Declares that a slot contains no triangle.
  void forget(TriangleId id);
  /// Removes a triangle from the part.
  void drop(TriangleId id);

  /// Writes triangles, and the names of slots whose triangles the receiver no longer holds.
  void write(std::span<const TriangleId> triangles, std::span<const Name> dropped, Writer& message);
  /// Takes over the triangles of several messages, each as written by write(), or empty.
  void read(std::span<const Ranks::Bytes> messages);

 private:
  struct TravellingVertex;
  struct TravellingTriangle;
  struct Arrived;

  [[nodiscard]] EdgeRef beyond(bool constrained) const { return {beyond_, 0, constrained}; }
  [[nodiscard]] std::uint64_t travelling(EdgeRef across) const;
  void detach(TriangleId id);
  [[nodiscard]] VertexId place(Name name, Point at);
  [[nodiscard]] TriangleId place(const TravellingTriangle& triangle, std::span<const VertexId> vertices);
  void link(const TravellingTriangle& triangle, TriangleId id);
  [[nodiscard]] Index new_vertex();
  [[nodiscard]] Index new_slot();
  void make_room();

  Triangulation& t_;
  HeldSegments* segments_;
  IndexAllocator &vertices_, *triangles_;
  std::optional<IndexAllocator> final_triangles_;  ///< after finish()
  Common common_;
  Names vertex_names_, triangle_names_;
  TriangleId beyond_;   ///< stands for all triangles that are not held
  VertexId no_corner_;  ///< the corner of all slots without triangles; its coordinates are NaN
  IndexPool new_vertices_;
  std::vector<VertexId> vertices_of_others_;
  std::vector<TriangleId> spare_;  ///< slots without triangles
  SparseArray<char> is_known_elsewhere_;
  SparseArray<Index> place_in_message_;  ///< scratch memory of write(): per vertex its place plus 1, or 0
};

template <class Visit>
void Subdomain::for_each_triangle(TriangleId first, TriangleId last, const Visit& visit) const {
  // Copies, because the compiler would load the originals again after each visit.
  const Slot* const slots = t_.slots.data();
  const VertexId no_corner = no_corner_;
  triangles_->for_each_used(first, last, [&](IndexRange used) {
    for (TriangleId id = used.begin; id < used.end; ++id)
      if (slots[id].v[0] != no_corner) visit(id);
  });
}

}  // namespace pardel::engine
