// The order of points by x, then y: from left to right, and along every line.
#pragma once

#include "../../core/pslg.hpp"

namespace pardel::engine {

[[nodiscard]] inline bool before(Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

}  // namespace pardel::engine
