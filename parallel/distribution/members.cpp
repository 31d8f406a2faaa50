#include "members.hpp"

#include <algorithm>
#include <utility>

#include "../concurrency/parallel_arrays.hpp"

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

Members::Members(const Triangulation& t, std::size_t inputs, const Distribution& distribution, const Threads& threads)
    : triangles_(0, 0), vertices_(0, 0) {
  find_home(t, distribution, threads);
  classify_triangles(t, distribution, threads);
  // A point of the input that is in no triangle belongs to the piece of its owner, too.
  for (VertexId v = 0; v < inputs; ++v)
    if (vertex_[v] == at_home) vertex_[v] = at_home | exists | in_piece;
  list_vertices(threads);
}

void Members::find_home(const Triangulation& t, const Distribution& distribution, const Threads& threads) {
  vertex_ = Array<char>::zeroes(t.points.size());
  for (const Distribution::Insertions& each : distribution.insertions())
    if (distribution.is_interior(each.cell))
      std::fill(vertex_.begin() + each.vertices.begin, vertex_.begin() + each.vertices.end, at_home);
  parallel_blocks(threads, vertex_.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t v = first; v < last; ++v)
      if (vertex_[v] == 0 && distribution.owner_of(static_cast<VertexId>(v)) == distribution.network().rank())
        vertex_[v] = at_home;
  });
}

void Members::classify_triangles(const Triangulation& t, const Distribution& distribution, const Threads& threads) {
  ListsOfBlocks<IndexRange> unused(t.slots.size());
  ListsOfBlocks<TriangleId> at_border(t.slots.size()), of_others(t.slots.size());
  ListsOfBlocks<EdgeRef> constrained(t.slots.size());
  parallel_blocks(threads, t.slots.size(), [&](std::size_t first, std::size_t last, std::size_t block) {
    Unused gaps(unused[block]);
    auto next = static_cast<TriangleId>(first);
    const Slot* const slots = t.slots.data();
    const auto classify = [&, slots](TriangleId id) {
      const Slot& slot = slots[id];
      const int a = marks_of(slot.v[0]), b = marks_of(slot.v[1]), c = marks_of(slot.v[2]);
      bool is_member = true;
      if ((a & b & c & at_home) == 0) {
        is_member = ((a | b | c) & at_home) != 0 && distribution.owner_of_triangle(id) == distribution.network().rank();
        (is_member ? at_border : of_others)[block].push_back(id);
      }
      if (id != next || !is_member) gaps.add({next, is_member ? id : id + 1});
      next = id + 1;
      if ((a & b & c) != (exists | in_piece | at_home))
        for (const VertexId corner : slot.v) mark(corner, is_member ? exists | in_piece : exists);
      if (!slot.any_constrained()) return;
      for (unsigned side = 0; side < 3; ++side)
        if (slot.n[side].constrained()) constrained[block].push_back({id, side});
    };
    distribution.part().for_each_triangle(static_cast<TriangleId>(first), static_cast<TriangleId>(last), classify);
    gaps.add({next, static_cast<TriangleId>(last)});
  });
  triangles_ = all_but(t.slots.size(), unused);
  at_border_ = at_border.joined();
  of_others_ = of_others.joined();
  constrained_sides_ = constrained.joined();
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
