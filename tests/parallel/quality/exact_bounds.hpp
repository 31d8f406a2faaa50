// The bounds on a triangle by exact arithmetic, independent of the engine's own criteria.
#pragma once

#include "../../../parallel/triangulation/triangle_shape.hpp"
#include "../../../properties/checker/arithmetic/exact.hpp"
#include "../../../properties/checker/check.hpp"

namespace pardel::engine {

/// True if an angle is smaller than `degrees`, by the exact arithmetic of the checker.
inline bool sharper_than(const Shape& s, double degrees) {
  for (unsigned i = 0; i < 3; ++i)
    if (checker::exactly::cosine_exceeds(s.p[i], s.p[(i + 1) % 3], s.p[(i + 2) % 3], angle_cosine_bound(degrees)))
      return true;
  return false;
}

/// True if the area exceeds the cap, by the exact arithmetic of the checker.
inline bool larger_than(const Shape& s, double cap) {
  return checker::exactly::area_exceeds(s.p[0], s.p[1], s.p[2], cap);
}

}  // namespace pardel::engine
