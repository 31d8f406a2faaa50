// What the predicates do when the inline filter cannot decide: stages of rising cost, each of which either
// knows the sign for certain or hands on to the next. Which one decided is part of the answer, so that tests
// can hold every stage to account.
#pragma once

#include <cstdint>

#include "../../core/pslg.hpp"

namespace pardel::engine::exact {

enum class Stage : std::uint8_t {
  lattice,              ///< the differences are small multiples of one unit: double arithmetic makes no error
  exact_differences,    ///< the differences of coordinates are doubles: one exact determinant of them
  rounded_differences,  ///< they are not, but the exact determinant of their roundings is far enough from zero
  corrected,            ///< first-order correction for what the differences lost
  expansions,           ///< everything, exactly
};

/// value has the exact sign and approximates the determinant.
struct Decision {
  double value;
  Stage stage;
};

/// Preconditions as in predicates.hpp.
[[nodiscard]] Decision decide_orient2d(Point a, Point b, Point c);
[[nodiscard]] Decision decide_incircle(Point a, Point b, Point c, Point d);

}  // namespace pardel::engine::exact
