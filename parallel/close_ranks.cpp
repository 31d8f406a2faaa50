#include "close_ranks.hpp"

#include <vector>

#include "../core/mutants.hpp"
#include "parallel_for.hpp"

namespace pardel {
namespace {

void close_triangles(Triangulation& t, const NumberLedger& numbers) {
  for (const NumberMove move : moves_into_holes(numbers)) {
    t.move_triangle(move.from, move.to);
    if (!t.region.empty()) t.region[move.to] = mutated("region_left_behind") ? 0 : t.region[move.from];
  }
  t.slots.resize(numbers.in_use());
  if (!t.region.empty()) t.region.resize(numbers.in_use());
}

void close_vertices(Triangulation& t, const NumberLedger& numbers, int threads) {
  const std::vector<NumberMove> moves = moves_into_holes(numbers);
  const VertexId vertices = numbers.in_use();
  std::vector<VertexId> moved_to(t.points.size() - vertices, no_index);
  for (const NumberMove move : moves) {
    t.points[move.to] = t.points[move.from];
    if (!mutated("origin_left_behind")) t.origin[move.to] = t.origin[move.from];
    moved_to[move.from - vertices] = move.to;
  }
  if (!moves.empty())
    parallel_blocks(threads, t.slots.size(), [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t id = first; id < last; ++id)
        for (VertexId& v : t.slots[id].v)
          if (v >= vertices) v = moved_to[v - vertices];
    });
  t.points.resize(vertices);
  t.origin.resize(vertices);
}

}  // namespace

void close_ranks(Triangulation& t, const NumberLedger& vertices, const NumberLedger& triangles, int threads) {
  close_triangles(t, triangles);
  close_vertices(t, vertices, threads);
  t.slots.shrink_to_fit();
  t.points.shrink_to_fit();
  t.origin.shrink_to_fit();
  t.region.shrink_to_fit();
}

}  // namespace pardel
