// The points at which two segments continue each other on a straight line.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "../pslg.hpp"
#include "stop_signal.hpp"

namespace pardel {

/// Called with the points of a path of segments, at least three. True if they lie on the straight line through the
/// first and the last of them, up to rounding, and follow each other along it.
using IsStraight = std::function<bool(std::span<const Index> path)>;

/// The points at which paths of segments are straight, one flag per point. Exactly two segments end at such a point. It
/// lies inside a path that `is_straight` accepts and whose other points are such points, too; only its two ends are
/// not. A path that is not straight is divided at the point that is farthest from the line through its ends, as
/// Douglas and Peucker do, "Algorithms for the reduction of the number of points required to represent a digitized line
/// or its caricature", 1973. So no point is straight at which segments turn visibly.
///
/// Segments without length do not count. The order and the directions of the segments do not matter, unless points are
/// equally far from a line. Time O(n log n) for n segments. Precondition: segment ids are in range.
[[nodiscard]] std::vector<bool> straight_points(std::span<const Point> points, std::span<const Segment> segments,
                                                const IsStraight& is_straight, StopSignal* stop = nullptr);

}  // namespace pardel
