// The exact part of the predicates, used if the inline filter cannot determine the sign. It consists of stages of
// increasing cost. Each stage either determines the sign with certainty or calls the next stage. The result names the
// stage that determined the sign, so tests can examine each stage separately.
#pragma once

#include <cstdint>

#include "../../core/pslg.hpp"

namespace pardel::engine::exact {

enum class Stage : std::uint8_t {
  lattice,              ///< the differences are small multiples of one unit, so double arithmetic is exact
  exact_differences,    ///< the differences of coordinates are doubles; their determinant is computed exactly
  rounded_differences,  ///< the exact determinant of the rounded differences is far enough from zero
  corrected,            ///< as before, after a first-order correction for the rounding of the differences
  expansions,           ///< the whole determinant is computed exactly
};

/// `value` has the exact sign of the determinant and approximates its magnitude.
struct Decision {
  double value;
  Stage stage;
};

/// Preconditions as in predicates.hpp.
[[nodiscard]] Decision decide_orient2d(Point a, Point b, Point c);
[[nodiscard]] Decision decide_incircle(Point a, Point b, Point c, Point d);

}  // namespace pardel::engine::exact
