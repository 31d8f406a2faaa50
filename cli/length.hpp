// The distance of two points.
#pragma once

#include <cmath>

#include "../core/pslg.hpp"

namespace pardel::cli {

inline double length(Point p, Point q) { return std::hypot(q.x - p.x, q.y - p.y); }

}  // namespace pardel::cli
