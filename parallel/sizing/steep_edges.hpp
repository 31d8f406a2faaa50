// The edges of a triangulation from which a limit on gradation has to start.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "../../core/size_source.hpp"

namespace pardel::engine {

/// The field is linear on each triangle. Its limit at x is the least of value(y) + grading * |x - y| over all points y
/// of the triangles. If y is nearest to x among the best points and y != x, the values fall by more than `grading` from
/// a point near y towards y. So y lies on an edge of a triangle that is steeper than `grading`, or on the boundary.
/// Returns these edges. O(n log n).
[[nodiscard]] std::vector<SizeSource> steep_edges(std::span<const Point> points,
                                                  std::span<const std::array<Index, 3>> triangles,
                                                  std::span<const double> values, double grading);

}  // namespace pardel::engine
