// Conflicts: places, other than common ends, at which two segments, or a segment and a point, meet.
#pragma once

#include <compare>
#include <cstdint>
#include <span>

#include "../../core/pslg.hpp"

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

/// The common point of the lines ab and cd, each coordinate with an error of a few units in the last place.
/// Precondition: they are not parallel.
[[nodiscard]] Point crossing_point(Point a, Point b, Point c, Point d);

/// -1, 0 or 1 if the common point of the lines ab and cd comes lexicographically before p, is p, or comes after p.
/// Exact. Precondition: the lines are not parallel.
[[nodiscard]] int compare_crossing(Point a, Point b, Point c, Point d, Point p);

/// The place of a conflict. Crossing: the common point, each coordinate with an error of a few units in the last place.
/// Overlap: the lexicographically smaller end of the common part. Point on a segment: the point.
[[nodiscard]] Point place_of(const Conflict& conflict, std::span<const Point> points,
                             std::span<const Segment> segments);

}  // namespace pardel::engine
