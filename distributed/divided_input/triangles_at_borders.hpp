// What the home of a triangle tells the other ranks that have it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "../../core/support/exchange_lists.hpp"
#include "../../core/support/message.hpp"
#include "../../core/support/without_repetitions.hpp"
#include "../../parallel/triangulation/triangle_shape.hpp"
#include "../delaunay/local_delaunay.hpp"
#include "../delaunay/own_points.hpp"

namespace pardel::engine {

/// A triangle that this rank has, and another rank is the home of.
struct ToldTriangle {
  TriangleId id;
  int home;
  Index value;  ///< what the home says
};

/// A triangle is at home on the rank that owns its lexicographically least corner. All ranks that own a corner have it.
/// Returns what this rank is told: one entry for each of its triangles that is at home elsewhere. Collective.
/// `has(id)`: whether the triangle in a slot counts; it has an own corner, and counts on all ranks that have it, or on
/// none. `value(id)`: what this rank says of a triangle that is at home here.
template <class Has, class Value>
[[nodiscard]] std::vector<ToldTriangle> told_by_homes(const LocalDelaunay& delaunay, const OwnPoints& own, Ranks& ranks,
                                                      const Has& has, const Value& value) {
  using Corners = std::array<std::uint64_t, 3>;  // their positions, ascending
  struct Told {
    Corners corners;
    Index value;
    Index unused = 0;
  };
  const Triangulation& t = delaunay.triangulation();
  const auto corners_of = [&](const Slot& slot) {
    Corners corners;
    std::ranges::transform(slot.v, corners.begin(), [&](VertexId v) { return delaunay.site(v).position; });
    std::ranges::sort(corners);
    return corners;
  };
  const auto owner = [&](VertexId v) { return own.owner(delaunay.site(v).position); };
  std::vector<std::vector<Told>> told(static_cast<std::size_t>(ranks.count()));
  std::map<Corners, TriangleId> awaited;
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    const Slot& slot = t.slots[id];
    if (std::ranges::all_of(slot.v, [&](VertexId v) { return v != ghost && delaunay.is_own(v); }) || !has(id)) continue;
    const int home = owner(least_corner(t, slot));
    if (home != ranks.rank()) {
      awaited.emplace(corners_of(slot), id);
      continue;
    }
    std::vector<int> others{owner(slot.v[0]), owner(slot.v[1]), owner(slot.v[2])};
    sort_without_repetitions(others);
    for (const int rank : others)
      if (rank != ranks.rank()) told[rank].push_back({corners_of(slot), value(id)});
  }
  const auto arrived = exchange_lists(std::move(told), ranks);
  std::vector<ToldTriangle> result;
  for (int rank = 0; rank < ranks.count(); ++rank)
    for (const Told& each : arrived[rank]) {
      const auto at = awaited.find(each.corners);
      if (at == awaited.end()) throw Reader::does_not_match();
      result.push_back({at->second, rank, each.value});
    }
  if (result.size() != awaited.size()) throw Reader::does_not_match();
  return result;
}

}  // namespace pardel::engine
