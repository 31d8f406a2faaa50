// The order of points along a Hilbert curve: neighbours in the order are close in the plane.
#pragma once

#include <span>

#include "../../core/array.hpp"
#include "../../core/pslg.hpp"
#include "threads.hpp"

namespace pardel::engine {

/// The indices of the points, ordered along a Hilbert curve through a grid of 2^16 by 2^16 cells over their bounding
/// square. Points in one cell are ordered recursively, along a curve through that cell. The order depends on
/// coordinates only, not on the order of the input, except among equal points. The number of threads does not change
/// the order. O(n) on typical input.
[[nodiscard]] Array<Index> hilbert_order(std::span<const Point> points, const Threads& threads = {});

}  // namespace pardel::engine
