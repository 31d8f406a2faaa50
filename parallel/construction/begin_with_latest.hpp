// The first corners of the triangles of a Delaunay triangulation.
#pragma once

#include <algorithm>
#include <array>

#include "../threads/parallel_arrays.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// If the first points are on a line, the first point off the line is inserted third, before the others on the line. So
/// it counts as early, whatever when() says.
template <class When>
[[nodiscard]] auto with_early_third(VertexId third, const When& when) {
  return [third, when](VertexId v) {
    using Time = decltype(when(v));
    return v == third ? Time{} : when(v);
  };
}

/// Turns the triangles that do not begin with their latest corner, as they do if points are inserted one by one. Only
/// the triangle of the first three points begins with the first one. So the first corner, on which the order of the
/// refinement depends, follows from the points alone.
///
/// `when(v)`: greater for later vertices. `first_three`: the first two, and the first one that is not on a line with
/// them, which is inserted third (see with_early_third()).
template <class When>
void begin_with_latest(Triangulation& t, const std::array<VertexId, 3>& first_three, const When& when,
                       const Threads& threads) {
  const auto latest = [&](const Slot& slot) -> unsigned {
    const auto first = when(slot.v[0]), second = when(slot.v[1]), third = when(slot.v[2]);
    return first > second ? (first > third ? 0 : 2) : (second > third ? 1 : 2);
  };
  const auto beginning = [&](const Slot& slot) -> unsigned {
    const bool is_first =
        std::ranges::all_of(slot.v, [&](VertexId v) { return std::ranges::count(first_three, v) == 1; });
    return is_first ? slot.corner_of(first_three[0]) : latest(slot);
  };
  const Array<Index> others = indices_where(threads, t.slots.size(), [&](std::size_t id) {
    const Slot& slot = t.slots[id];
    const bool may_be_first = slot.v[0] == first_three[1] || slot.v[0] == first_three[2];
    return !slot.is_ghost() && (may_be_first || latest(slot) != 0) && beginning(slot) != 0;
  });
  for (const TriangleId id : others) t.turn(id, beginning(t.slots[id]));
}

}  // namespace pardel::engine
