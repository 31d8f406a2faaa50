// The convex hull of points.
#pragma once

#include <span>
#include <vector>

#include "../../core/pslg.hpp"
#include "../threads/threads.hpp"

namespace pardel::engine {

/// True if all points lie on one line, and for fewer than three points. O(n); on typical input only three points are
/// examined.
[[nodiscard]] bool all_collinear(std::span<const Point> points, const Threads& threads = {});

/// All points on the boundary of the convex hull, including those in the interior of its edges, counter-clockwise from
/// the lexicographically smallest. Equal points occur once. Exact. Precondition: the points are not all collinear.
/// Time: O(n + h log h) on typical input, if h points lie outside an octagon of extreme points; O(n log n) at worst.
[[nodiscard]] std::vector<Index> convex_hull(std::span<const Point> points, const Threads& threads = {});

}  // namespace pardel::engine
