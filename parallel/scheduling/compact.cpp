#include "compact.hpp"

#include <vector>

#include "../concurrency/parallel_for.hpp"

namespace pardel::engine {
namespace {

/// The moves that close the ranks, and where what had a number from `in_use` on has gone.
struct Closing {
  std::vector<IndexMove> moves;
  Index in_use;
  std::vector<Index> moved_to;

  explicit Closing(const IndexAllocator& numbers) : moves(moves_into_holes(numbers)), in_use(numbers.in_use()) {
    if (!moves.empty()) moved_to.resize(moves.back().from + 1 - in_use, no_index);
    for (const IndexMove move : moves) moved_to[move.from - in_use] = move.to;
  }
  [[nodiscard]] bool has_moved(Index number) const { return number >= in_use; }
  [[nodiscard]] Index now(Index number) const { return moved_to[number - in_use]; }

  template <class Body>
  void for_each_move(int threads, const Body& body) const {
    parallel_blocks(threads, moves.size(), [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t i = first; i < last; ++i) body(moves[i].from, moves[i].to);
    });
  }
};

void close_triangles(Triangulation& t, const IndexAllocator& numbers, int threads) {
  const Closing closing(numbers);
  closing.for_each_move(threads, [&](TriangleId from, TriangleId to) {
    t.slots[to] = t.slots[from];
    if (!t.region.empty()) t.region[to] = t.region[from];
  });
  // Of two neighbours that have moved each looks up where the other is. One that stayed is told by the one that moved:
  // a side has one writer, and nobody reads it here.
  closing.for_each_move(threads, [&](TriangleId, TriangleId to) {
    for (unsigned side = 0; side < 3; ++side) {
      EdgeRef& out = t.slots[to].n[side];
      if (out.none()) continue;
      if (closing.has_moved(out.triangle()))
        out = EdgeRef(closing.now(out.triangle()), out.side(), out.constrained());
      else
        t.slots[out.triangle()].n[out.side()] = EdgeRef(to, side, out.constrained());
    }
  });
  t.slots.resize(closing.in_use);
  if (!t.region.empty()) t.region.resize(closing.in_use);
}

void close_vertices(Triangulation& t, const IndexAllocator& numbers, int threads) {
  const Closing closing(numbers);
  closing.for_each_move(threads, [&](VertexId from, VertexId to) {
    t.points[to] = t.points[from];
    t.origin[to] = t.origin[from];
  });
  if (!closing.moves.empty())
    parallel_blocks(threads, t.slots.size(), [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t id = first; id < last; ++id)
        for (VertexId& v : t.slots[id].v)
          if (closing.has_moved(v)) v = closing.now(v);
    });
  t.points.resize(closing.in_use);
  t.origin.resize(closing.in_use);
}

}  // namespace

void close_ranks(Triangulation& t, const IndexAllocator& vertices, const IndexAllocator& triangles, int threads) {
  close_triangles(t, triangles, threads);
  close_vertices(t, vertices, threads);
  t.slots.shrink_to_fit();
  t.points.shrink_to_fit();
  t.origin.shrink_to_fit();
  t.region.shrink_to_fit();
}

}  // namespace pardel::engine
