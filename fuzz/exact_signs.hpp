// The signs of the predicates by their definition, in whole numbers of any size (GMP).
#pragma once

#include "../core/pslg.hpp"

namespace pardel::fuzz {

/// +1 if a, b, c turn left, -1 if they turn right, 0 if they are collinear. Coordinates are finite.
[[nodiscard]] int true_orientation(Point a, Point b, Point c);

/// The sign of the in-circle determinant: for counter-clockwise a, b, c it is +1 if d lies inside their circumcircle,
/// -1 outside, 0 on it. Coordinates are finite.
[[nodiscard]] int true_incircle(Point a, Point b, Point c, Point d);

}  // namespace pardel::fuzz
