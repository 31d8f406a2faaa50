#include "members.hpp"

#include <algorithm>
#include <utility>

#include "../../parallel/threads/parallel_arrays.hpp"

namespace pardel::engine {
namespace {

/// Lists that the blocks of a parallel loop make.
template <class T>
class ListsOfBlocks {
 public:
  explicit ListsOfBlocks(std::size_t items) : lists_(block_count(items)) {}
  [[nodiscard]] std::vector<T>& operator[](std::size_t block) { return lists_[block]; }
  [[nodiscard]] std::vector<T> joined() const {
    std::vector<T> all;
    for (const std::vector<T>& list : lists_) all.insert(all.end(), list.begin(), list.end());
    return all;
  }

 private:
  std::vector<std::vector<T>> lists_;
};

/// The indices below n that are not in use, while they are found in ascending order.
class Unused {
 public:
  explicit Unused(std::vector<IndexRange>& ranges) : ranges_(ranges) {}
  void add(IndexRange range) {
    if (range.size() == 0) return;
    if (!ranges_.empty() && ranges_.back().end == range.begin)
      ranges_.back().end = range.end;
    else
      ranges_.push_back(range);
  }

 private:
  std::vector<IndexRange>& ranges_;
};

IndexAllocator all_but(std::size_t n, const ListsOfBlocks<IndexRange>& unused) {
  IndexAllocator indices(static_cast<Index>(n), static_cast<Index>(n));
  indices.release(IndexPool(unused.joined()));
  indices.settle();
  return indices;
}

}  // namespace

Members::Members(const Triangulation& t, const Distribution& distribution, const Threads& threads)
    : triangles_(0, 0), vertices_(0, 0) {
  mark_owned(t, distribution);
  classify_triangles(t, distribution, threads);
  correct_marks_at_border(t, distribution.part());
  list_vertices(threads);
}

/// Marks all vertices that the rank owns, as members of its piece.
void Members::mark_owned(const Triangulation& t, const Distribution& distribution) {
  vertex_ = Array<char>::zeroes(t.points.size());
  const auto mark_if_owned = [&](IndexRange range) {
    for (VertexId v = range.begin; v < range.end; ++v)
      if (distribution.owner_of(v) == distribution.network().rank()) vertex_[v] = in_piece | owned;
  };
  VertexId begin = 0;
  for (const IndexRange unused : distribution.unused_common()) {
    mark_if_owned({begin, unused.begin});
    begin = unused.end;
  }
  mark_if_owned({begin, std::max(distribution.common_vertices(), distribution.known_inputs())});
  for (const Distribution::Insertions& each : distribution.insertions())
    if (distribution.is_interior(each.cell))
      std::fill(vertex_.begin() + each.vertices.begin, vertex_.begin() + each.vertices.end, in_piece | owned);
    else
      mark_if_owned(each.vertices);
  for (const VertexId v : distribution.part().vertices_of_others()) mark_if_owned({v, v + 1});
}

/// A triangle with a corner of another rank is held by that rank. So a triangle that no other rank knows has only
/// corners of this rank, and most triangles need no closer look.
void Members::classify_triangles(const Triangulation& t, const Distribution& distribution, const Threads& threads) {
  const Subdomain& part = distribution.part();
  ListsOfBlocks<IndexRange> unused(t.slots.size());
  ListsOfBlocks<TriangleId> at_border(t.slots.size()), of_others(t.slots.size());
  ListsOfBlocks<EdgeRef> constrained(t.slots.size());
  parallel_blocks(threads, t.slots.size(), [&](std::size_t first, std::size_t last, std::size_t block) {
    Unused gaps(unused[block]);
    auto next = static_cast<TriangleId>(first);
    const Slot* const slots = t.slots.data();
    const auto is_of_piece = [&](TriangleId id) {
      const auto& v = slots[id].v;
      const bool is_member = (owns_vertex(v[0]) || owns_vertex(v[1]) || owns_vertex(v[2])) &&
                             distribution.owner_of_triangle(id) == distribution.network().rank();
      (is_member ? at_border : of_others)[block].push_back(id);
      return is_member;
    };
    const auto note = [&, slots](TriangleId id, bool is_member) {
      if (id != next || !is_member) gaps.add({next, is_member ? id : id + 1});
      next = id + 1;
      const Slot& slot = slots[id];
      if (!slot.any_constrained()) return;
      for (unsigned side = 0; side < 3; ++side)
        if (slot.n[side].constrained()) constrained[block].push_back({id, side});
    };
    const auto run_of = [&](TriangleId begin, TriangleId end, bool may_be_known) {
      if (!may_be_known) return part.for_each_triangle(begin, end, [&](TriangleId id) { note(id, true); });
      part.for_each_triangle(begin, end, [&](TriangleId id) {
        note(id, !part.is_known_elsewhere(id) || owns_all_corners(slots[id]) || is_of_piece(id));
      });
    };
    part.for_each_run(static_cast<TriangleId>(first), static_cast<TriangleId>(last), run_of);
    gaps.add({next, static_cast<TriangleId>(last)});
  });
  triangles_ = all_but(t.slots.size(), unused);
  at_border_ = at_border.joined();
  of_others_ = of_others.joined();
  constrained_sides_ = constrained.joined();
}

/// Of the vertices that the rank owns, only a corner of a triangle with a corner of another rank can be in no triangle
/// of the piece. Let v be such a corner. Triangles around v that share a side with v as an end form fans. A triangle of
/// the piece in a fan is in at_border(), or has only corners of this rank and is next to a triangle that has not, or
/// the fan has only triangles of the first kind and ends at boundary edges, which are constrained.
void Members::correct_marks_at_border(const Triangulation& t, const Subdomain& part) {
  const auto with_corners_of_others = {&at_border_, &of_others_};
  for (const std::vector<TriangleId>* list : with_corners_of_others)
    for (const TriangleId id : *list)
      for (const VertexId v : t.slots[id].v) vertex_[v] &= owned;
  for (const TriangleId id : at_border_) mark_corners(t.slots[id]);
  for (const std::vector<TriangleId>* list : with_corners_of_others)
    for (const TriangleId id : *list)
      for (const EdgeRef across : t.slots[id].n)
        if (!across.none() && !part.is_beyond(across) && owns_all_corners(t.slots[across.triangle()]))
          mark_corners(t.slots[across.triangle()]);
  for (const EdgeRef e : constrained_sides_)
    if (owns_all_corners(t.slot(e))) mark_corners(t.slot(e));
}

void Members::list_vertices(const Threads& threads) {
  ListsOfBlocks<IndexRange> unused(vertex_.size());
  ListsOfBlocks<VertexId> not_owned(vertex_.size());
  parallel_blocks(threads, vertex_.size(), [&](std::size_t first, std::size_t last, std::size_t block) {
    Unused gaps(unused[block]);
    for (auto v = static_cast<VertexId>(first); v < last; ++v)
      if (!has_vertex(v))
        gaps.add({v, v + 1});
      else if (!owns_vertex(v))
        not_owned[block].push_back(v);
  });
  vertices_ = all_but(vertex_.size(), unused);
  not_owned_ = not_owned.joined();
}

}  // namespace pardel::engine
