// Removal of triangles.
#pragma once

#include <span>

#include "../threads/threads.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// Removes the triangles for which is_removed(id) holds; `removed` lists them in ascending order. Their neighbours get
/// a boundary. The last remaining triangles move into the free slots, and on_move(from, to) is called for each move;
/// from then on is_removed(to) has to be false. All other triangles keep their ids. O(removed triangles).
template <class IsRemoved, class OnMove>
void remove_triangles(Triangulation& t, std::span<const TriangleId> removed, const IsRemoved& is_removed,
                      const OnMove& on_move, SparseAsk& ask) {
  for (const TriangleId id : removed) {
    ask();
    for (const EdgeRef out : t.slots[id].n)
      if (!out.none() && !is_removed(out.triangle())) t.slots[out.triangle()].n[out.side()] = EdgeRef();
  }
  const std::size_t kept = t.slots.size() - removed.size();
  auto last = static_cast<TriangleId>(t.slots.size());
  for (const TriangleId hole : removed) {
    if (hole >= kept) break;
    ask();
    do --last;
    while (is_removed(last));
    t.move_triangle(last, hole);
    on_move(last, hole);
  }
  t.slots.resize(kept);
}

}  // namespace pardel::engine
