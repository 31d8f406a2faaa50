// Does a field of sizes cover a domain?
#pragma once

#include <functional>
#include <span>

#include "../../core/pslg.hpp"
#include "../concurrency/threads.hpp"

namespace pardel::engine {

/// Throws the Error of a raster, or of a limited field on a background, that does not cover one of the points: the
/// first of them, on any number of threads. Other functions are not called.
///
/// `points`: the vertices of a domain. A convex field that covers them covers the domain. So the refinement may take
/// the size at a vertex as a bound on the sizes nearby, and need not look for the border of the field again.
void require_coverage(const std::function<double(Point)>& size, std::span<const Point> points, const Threads& threads);

}  // namespace pardel::engine
