// Rings: domains between two curves around the origin, which polylines approximate. Their smooth vertices and narrow
// places are what lattice domains lack.
#pragma once

#include <cmath>
#include <numbers>
#include <ostream>
#include <vector>

#include "../../../core/pslg.hpp"
#include "../../domains/generators/random.hpp"

namespace pardel::properties {

struct Ring {
  int vertices = 12;    ///< of each curve
  int waves = 3;        ///< of the outer curve
  double height = 0.1;  ///< of the waves; the radius of the outer curve is 1 + height * cos(waves * angle)
  double inner = 0.5;   ///< the radius of the hole; 0: no hole
};

inline std::ostream& operator<<(std::ostream& out, const Ring& r) {
  return out << r.vertices << " vertices, " << r.waves << " waves of height " << r.height << ", hole of radius "
             << r.inner;
}

[[nodiscard]] inline Pslg to_pslg(const Ring& ring) {
  Pslg pslg;
  const auto add_curve = [&](double radius, double height) {
    const auto first = static_cast<Index>(pslg.points.size()), n = static_cast<Index>(ring.vertices);
    for (Index k = 0; k < n; ++k) {
      const double angle = 2 * std::numbers::pi * k / n, r = radius + height * std::cos(ring.waves * angle);
      pslg.points.push_back({r * std::cos(angle), r * std::sin(angle)});
      pslg.segments.push_back({first + k, first + (k + 1) % n});
    }
  };
  add_curve(1, ring.height);
  if (ring.inner == 0) return pslg;
  add_curve(ring.inner, 0);
  pslg.holes.push_back({0, 0});
  return pslg;
}

[[nodiscard]] inline Ring random_ring(generators::Random& random, int size) {
  Ring ring{.vertices = random.between(5, 8 + size / 2),
            .waves = random.between(0, 6),
            .height = 0.01 * random.between(0, 25),
            .inner = 0.01 * random.between(0, 70)};
  // A polygon with few sides comes much closer to the hole than the curve.
  if (ring.inner > 0.9 * (1 - ring.height) * std::cos(std::numbers::pi / ring.vertices)) ring.inner = 0;
  return ring;
}

[[nodiscard]] inline std::vector<Ring> shrinks(const Ring& ring) {
  std::vector<Ring> simpler;
  if (ring.inner > 0) simpler.push_back({ring.vertices, ring.waves, ring.height, 0});
  if (ring.height > 0) simpler.push_back({ring.vertices, ring.waves, 0, ring.inner});
  if (ring.vertices > 5 && ring.inner == 0) simpler.push_back({ring.vertices - 1, ring.waves, ring.height, 0});
  return simpler;
}

}  // namespace pardel::properties
