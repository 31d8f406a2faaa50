#include "compact.hpp"

#include "../threads/parallel_arrays.hpp"

namespace pardel::engine {
namespace {

void compact_triangles(Triangulation& t, const IndexMoves& moves, const Threads& threads) {
  for_each_move(threads, moves, [&](TriangleId from, TriangleId to) {
    t.slots[to] = t.slots[from];
    if (!t.region.empty()) t.region[to] = t.region[from];
  });
  // If two neighbours have moved, each looks up the new index of the other. If only one has moved, it writes its new
  // index into the other. So each side is written once, and no thread reads a side that another thread writes.
  for_each_move(threads, moves, [&](TriangleId, TriangleId to) {
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

void compact_vertices(Triangulation& t, const IndexMoves& moves, const Threads& threads) {
  for_each_move(threads, moves, [&](VertexId from, VertexId to) {
    t.points[to] = t.points[from];
    t.origin[to] = t.origin[from];
  });
  t.points.resize(moves.in_use());
  t.origin.resize(moves.in_use());
}

}  // namespace

void compact(Triangulation& t, const IndexMoves& vertices, const IndexMoves& triangles, const Threads& threads) {
  compact_but_corners(t, vertices, triangles, threads);
  if (vertices.empty()) return;
  parallel_blocks(threads, t.slots.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t id = first; id < last; ++id)
      for (VertexId& v : t.slots[id].v)
        if (vertices.has_moved(v)) v = vertices.now(v);
  });
}

void compact_but_corners(Triangulation& t, const IndexMoves& vertices, const IndexMoves& triangles,
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
  compact(copy, IndexMoves(vertices), IndexMoves(triangles), threads);
  return copy;
}

}  // namespace pardel::engine
