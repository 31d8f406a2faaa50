// Search for points that are equal or closer than a distance.
#pragma once

#include <compare>
#include <span>
#include <vector>

#include "../../core/pslg.hpp"
#include "../segments/reach.hpp"
#include "../threads/threads.hpp"

namespace pardel::engine {

/// `first` has the lowest index among equal points; `again` is another one of them.
struct Duplicate {
  Index first;
  Index again;
  friend bool operator==(const Duplicate&, const Duplicate&) = default;
};

/// One entry for every point that equals an earlier point, in ascending order of `again`. -0 equals 0. A point with a
/// NaN equals no point. Expected time O(n): the points are partitioned by hash, and each part, which fits the cache,
/// gets a hash table of its own. The parts are processed in parallel.
[[nodiscard]] std::vector<Duplicate> find_duplicates(std::span<const Point> points, const Threads& threads = {});

/// Points are visited in ascending order. A point that is equal to an earlier point, or closer to it than `reach`
/// allows, becomes a duplicate of the earlier point, unless the earlier point is a duplicate itself. If there are
/// several such earlier points, the one with the lowest index is used. So no two points that are not duplicates are in
/// reach of each other. Preconditions: coordinates are in the range of the predicates; `reach` knows these points.
/// Expected time O(n) if points in reach of each other are few and scales differ little.
[[nodiscard]] std::vector<Duplicate> find_close(std::span<const Point> points, const Reach& reach,
                                                StopSignal* stop = nullptr);

/// A segment and its ends; `low` is the smaller index.
struct Ends {
  Index low, high, segment;
  friend auto operator<=>(const Ends&, const Ends&) = default;  // NOLINT(modernize-use-nullptr)
};
/// The ends of all segments, sorted: segments with the same ends are neighbours, in ascending order. Precondition: the
/// ends are smaller than `points`. O(n log n); linear if few segments meet at each point.
[[nodiscard]] std::vector<Ends> sorted_ends(std::span<const Segment> segments, std::size_t points,
                                            StopSignal* stop = nullptr);

}  // namespace pardel::engine
