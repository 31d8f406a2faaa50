// Does a field of sizes cover all vertices of a domain?
#pragma once

#include <functional>
#include <span>

#include "../../core/pslg.hpp"
#include "../threads/threads.hpp"

namespace pardel::engine {

/// True for a raster and for a limited field on a background: they have no value at points that they do not cover.
[[nodiscard]] bool ends_somewhere(const std::function<double(Point)>& size);

/// Throws the Error of a field that does not cover one of the points: the first of them, on any number of threads.
/// Calls no function that does not end somewhere.
///
/// `points`: the vertices of a domain. A convex field that covers them covers the domain. So the refinement may take
/// the size at a vertex as a bound on the sizes nearby, and need not look for the border of the field again.
void require_coverage(const std::function<double(Point)>& size, std::span<const Point> points, const Threads& threads);

}  // namespace pardel::engine
