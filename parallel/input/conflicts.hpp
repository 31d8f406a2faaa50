// Where segments do what only their common ends may do: meet.
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
  crossing,          ///< two segments have a point in common that is interior to both
  overlapping,       ///< two segments are collinear and have more than a point in common
  point_on_segment,  ///< a point, the end of a segment or not, is interior to a segment
};

/// first, second: two segments, ascending; or a point and a segment.
struct Conflict {
  ConflictKind kind;
  Index first;
  Index second;
  friend auto operator<=>(const Conflict&, const Conflict&) = default;  // NOLINT(modernize-use-nullptr)
};

/// Every conflict once, in ascending order; but the search ends as soon as there are `most` of one kind. Exact.
/// `candidates`: the points to look at that no segment names (all of them, but for those that equal another, say).
/// Preconditions: the points that segments name are distinct and in the predicates' range; no two segments have the
/// same ends, none has equal ends. Time: O(n log n) and what pairs of segments with intersecting bounding boxes take,
/// which is quadratic for many long slanted segments side by side, or around one vertex (0.8 s for 10,000 spokes).
[[nodiscard]] std::vector<Conflict> find_conflicts(std::span<const Point> points, std::span<const Segment> segments,
                                                   std::span<const Index> candidates, const SegmentIndex& index,
                                                   std::size_t most = std::numeric_limits<std::size_t>::max());

/// Where it happens: the crossing, each coordinate rounded (with an error of a few units in its last place); the
/// end, first by x, then y, of what overlapping segments have in common; the point on the segment.
[[nodiscard]] Point place_of(const Conflict& conflict, std::span<const Point> points,
                             std::span<const Segment> segments);

}  // namespace pardel::engine
