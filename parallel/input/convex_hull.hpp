// The convex hull of points.
#pragma once

#include <span>
#include <vector>

#include "../../core/pslg.hpp"

namespace pardel::engine {

/// True also for fewer than three points. O(n); mostly three points decide.
[[nodiscard]] bool all_collinear(std::span<const Point> points);

/// The points on the boundary of the convex hull, those in the interior of its edges included, counter-clockwise
/// from the one that comes first by x, then y. Of equal points one is taken. Exact. O(n + h log h) typical, h the
/// points that are not inside an octagon of extreme ones; O(n log n) at worst. Precondition: not all collinear.
[[nodiscard]] std::vector<Index> convex_hull(std::span<const Point> points);

}  // namespace pardel::engine
