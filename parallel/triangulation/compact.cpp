#include "compact.hpp"

#include <vector>

#include "../concurrency/parallel_for.hpp"

namespace pardel::engine {
namespace {

/// The moves into unused indices, and the new index of each element that has moved.
class Moves {
 public:
  explicit Moves(const IndexAllocator& indices) : moves_(moves_into_holes(indices)), in_use_(indices.in_use()) {
    if (!moves_.empty()) moved_to_.resize(moves_.back().from + 1 - in_use_, no_index);
    for (const IndexMove move : moves_) moved_to_[move.from - in_use_] = move.to;
  }
  [[nodiscard]] bool empty() const { return moves_.empty(); }
  [[nodiscard]] Index in_use() const { return in_use_; }
  [[nodiscard]] bool has_moved(Index index) const { return index >= in_use_; }
  /// Precondition: has_moved(index).
  [[nodiscard]] Index now(Index index) const { return moved_to_[index - in_use_]; }

  template <class Body>
  void for_each(const Threads& threads, const Body& body) const {
    parallel_blocks(threads, moves_.size(), [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t i = first; i < last; ++i) body(moves_[i].from, moves_[i].to);
    });
  }

 private:
  std::vector<IndexMove> moves_;
  Index in_use_;
  std::vector<Index> moved_to_;
};

void compact_triangles(Triangulation& t, const IndexAllocator& indices, const Threads& threads) {
  const Moves moves(indices);
  moves.for_each(threads, [&](TriangleId from, TriangleId to) {
    t.slots[to] = t.slots[from];
    if (!t.region.empty()) t.region[to] = t.region[from];
  });
  // If two neighbours have moved, each looks up the new index of the other. If only one has moved, it writes its new
  // index into the other. So each side is written once, and no thread reads a side that another thread writes.
  moves.for_each(threads, [&](TriangleId, TriangleId to) {
    for (unsigned side = 0; side < 3; ++side) {
      EdgeRef& out = t.slots[to].n[side];
      if (out.none()) continue;
      if (moves.has_moved(out.triangle()))
        out = EdgeRef(moves.now(out.triangle()), out.side(), out.constrained());
      else
        t.slots[out.triangle()].n[out.side()] = EdgeRef(to, side, out.constrained());
    }
  });
  t.slots.resize(moves.in_use());
  if (!t.region.empty()) t.region.resize(moves.in_use());
}

void compact_vertices(Triangulation& t, const IndexAllocator& indices, const Threads& threads) {
  const Moves moves(indices);
  moves.for_each(threads, [&](VertexId from, VertexId to) {
    t.points[to] = t.points[from];
    t.origin[to] = t.origin[from];
  });
  if (!moves.empty())
    parallel_blocks(threads, t.slots.size(), [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t id = first; id < last; ++id)
        for (VertexId& v : t.slots[id].v)
          if (moves.has_moved(v)) v = moves.now(v);
    });
  t.points.resize(moves.in_use());
  t.origin.resize(moves.in_use());
}

}  // namespace

void compact(Triangulation& t, const IndexAllocator& vertices, const IndexAllocator& triangles,
             const Threads& threads) {
  compact_triangles(t, triangles, threads);
  compact_vertices(t, vertices, threads);
  t.slots.shrink_to_fit();
  t.points.shrink_to_fit();
  t.origin.shrink_to_fit();
  t.region.shrink_to_fit();
}

Triangulation compacted_copy(const Triangulation& t, const IndexAllocator& vertices, const IndexAllocator& triangles,
                             const Threads& threads) {
  Triangulation copy = t;
  compact(copy, vertices, triangles, threads);
  return copy;
}

}  // namespace pardel::engine
