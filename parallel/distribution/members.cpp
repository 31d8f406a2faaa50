#include "members.hpp"

#include <algorithm>

#include "../concurrency/parallel_arrays.hpp"

namespace pardel::engine {

Members::Members(const Triangulation& t, std::size_t inputs, const Distribution& distribution, const Threads& threads) {
  classify_vertices(t, distribution, threads);
  classify_triangles(t, distribution, threads);
  // A point of the input that is in no triangle belongs to the piece of its owner, too.
  for (VertexId v = 0; v < inputs; ++v)
    if (vertex_[v] == at_home) vertex_[v] = at_home | exists | in_piece;
}

void Members::classify_vertices(const Triangulation& t, const Distribution& distribution, const Threads& threads) {
  cell_.resize_uninitialised(t.points.size());
  vertex_.resize_uninitialised(t.points.size());
  parallel_blocks(threads, t.points.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t v = first; v < last; ++v) {
      cell_[v] = distribution.cell_of(static_cast<VertexId>(v));
      vertex_[v] = distribution.ownership().owner(cell_[v]) == distribution.network().rank() ? at_home : char{0};
    }
  });
}

void Members::classify_triangles(const Triangulation& t, const Distribution& distribution, const Threads& threads) {
  triangle_ = Array<char>::zeroes(t.slots.size());
  const std::size_t blocks = block_count(t.slots.size());
  std::vector<std::vector<TriangleId>> at_border(blocks);
  std::vector<std::vector<EdgeRef>> constrained(blocks);
  parallel_blocks(threads, t.slots.size(), [&](std::size_t first, std::size_t last, std::size_t block) {
    const auto classify = [&](TriangleId id) {
      const Slot& slot = t.slots[id];
      bool is_member = true;
      if ((marks_of(slot.v[0]) & marks_of(slot.v[1]) & marks_of(slot.v[2]) & at_home) == 0) {
        at_border[block].push_back(id);
        is_member = distribution.owner_of_triangle(id) == distribution.network().rank();
      }
      triangle_[id] = static_cast<char>(is_member);
      for (const VertexId corner : slot.v) mark(corner, is_member ? exists | in_piece : exists);
      if (!slot.any_constrained()) return;
      for (unsigned side = 0; side < 3; ++side)
        if (slot.n[side].constrained()) constrained[block].push_back({id, side});
    };
    distribution.part().for_each_triangle(static_cast<TriangleId>(first), static_cast<TriangleId>(last), classify);
  });
  for (const auto& of_block : at_border) at_border_.insert(at_border_.end(), of_block.begin(), of_block.end());
  for (const auto& of_block : constrained)
    constrained_sides_.insert(constrained_sides_.end(), of_block.begin(), of_block.end());
}

}  // namespace pardel::engine
