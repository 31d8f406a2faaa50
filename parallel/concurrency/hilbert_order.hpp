// Orders points so that neighbours in the order are neighbours in the plane.
#pragma once

#include <span>

#include "../../core/array.hpp"
#include "../../core/pslg.hpp"

namespace pardel::engine {

/// The indices of the points along a Hilbert curve over their bounding square; points that share a cell of
/// the finest grid are ordered along a curve of their own. Depends on coordinates only, not on the order
/// of the input (but for equal points). O(n) typical.
[[nodiscard]] Array<Index> hilbert_order(std::span<const Point> points, int threads = 1);

}  // namespace pardel::engine
