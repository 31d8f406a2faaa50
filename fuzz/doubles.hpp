// Doubles that are made from bits, or a few units in the last place away from others.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pardel::fuzz {

/// The sign and the mantissa of the bits, with this exponent: a number between 2^exponent and 2^(exponent + 1).
[[nodiscard]] inline double with_exponent(std::uint64_t bits, int exponent) {
  return std::ldexp(std::bit_cast<double>((bits & 0x800fffffffffffff) | 0x3ff0000000000000), exponent);
}

/// x, moved up by so many units in the last place, or down.
[[nodiscard]] inline double moved(double x, int units) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (; units > 0; --units) x = std::nextafter(x, infinity);
  for (; units < 0; ++units) x = std::nextafter(x, -infinity);
  return x;
}

[[nodiscard]] inline int sign(double x) { return (x > 0) - (x < 0); }

}  // namespace pardel::fuzz
