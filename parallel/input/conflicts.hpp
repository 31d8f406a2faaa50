// Conflicts: places, other than common ends, at which two segments, or a segment and a point, meet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "../../core/pslg.hpp"
#include "segment_index.hpp"

namespace pardel::engine {

enum class ConflictKind : std::uint8_t {
  crossing,          ///< two segments have a common point that is interior to both
  overlapping,       ///< two segments are collinear and have more than one common point
  point_on_segment,  ///< a point is interior to a segment
};

/// `first` and `second`: two segments in ascending order; for point_on_segment, the point and the segment.
struct Conflict {
  ConflictKind kind;
  Index first;
  Index second;
  friend auto operator<=>(const Conflict&, const Conflict&) = default;  // NOLINT(modernize-use-nullptr)
};

/// All conflicts, without duplicates, in ascending order. The search ends as soon as it has found `most` of one kind.
/// Exact. `candidates`: the points to examine that are not an end of a segment.
/// Preconditions: the ends of segments are distinct points in the range of the predicates; no two segments have the
/// same ends, and no segment has equal ends. Time: O(n log n), and constant time for each pair of segments whose
/// bounding boxes intersect. The number of these pairs is quadratic for many long slanted parallel segments, or for
/// many segments around one vertex (0.8 s for 10,000 spokes).
[[nodiscard]] std::vector<Conflict> find_conflicts(std::span<const Point> points, std::span<const Segment> segments,
                                                   std::span<const Index> candidates, const SegmentIndex& index,
                                                   std::size_t most = std::numeric_limits<std::size_t>::max());

/// The place of a conflict. Crossing: the common point, each coordinate with an error of a few units in the last place.
/// Overlap: the lexicographically smaller end of the common part. Point on a segment: the point.
[[nodiscard]] Point place_of(const Conflict& conflict, std::span<const Point> points,
                             std::span<const Segment> segments);

}  // namespace pardel::engine
