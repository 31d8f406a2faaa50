// Two doubles in one SIMD register, with the same operation applied to both halves. Each half is rounded as a single
// double would be, so results are the same as without SIMD. The type is an extension of GCC and Clang.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "../../core/pslg.hpp"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace pardel::engine {

using Pair __attribute__((vector_size(2 * sizeof(double)))) = double;
/// The result of a comparison of two pairs. In each half all bits are 1 for true and 0 for false.
using PairBits __attribute__((vector_size(2 * sizeof(std::int64_t)))) = std::int64_t;

/// The coordinates of a point.
[[nodiscard]] inline Pair as_pair(const Point& p) { return std::bit_cast<Pair>(p); }
[[nodiscard]] inline Point as_point(Pair p) { return std::bit_cast<Point>(p); }
[[nodiscard]] inline Pair firsts(Pair a, Pair b) { return __builtin_shufflevector(a, b, 0, 2); }
[[nodiscard]] inline Pair seconds(Pair a, Pair b) { return __builtin_shufflevector(a, b, 1, 3); }

/// Bit 0 is the result for the first half, bit 1 the result for the second half.
[[nodiscard]] inline unsigned bits(PairBits mask) {
#ifdef __SSE2__
  return static_cast<unsigned>(_mm_movemask_pd(std::bit_cast<Pair>(mask)));
#else
  return static_cast<unsigned>((mask[0] & 1) | (mask[1] & 2));
#endif
}

// The same names for double and Pair, for use in templates.
[[nodiscard]] inline bool all(bool mask) { return mask; }
[[nodiscard]] inline bool all(PairBits mask) { return bits(mask) == 3; }
[[nodiscard]] inline double magnitude(double a) { return std::abs(a); }
[[nodiscard]] inline Pair magnitude(Pair a) {
  return std::bit_cast<Pair>(std::bit_cast<PairBits>(a) & std::int64_t{0x7fff'ffff'ffff'ffff});
}
[[nodiscard]] inline double least(double a, double b) { return std::min(a, b); }
[[nodiscard]] inline Pair least(Pair a, Pair b) {
#ifdef __SSE2__
  return std::bit_cast<Pair>(_mm_min_pd(b, a));
#else
  return b < a ? b : a;
#endif
}
[[nodiscard]] inline double greatest(double a, double b) { return std::max(a, b); }
[[nodiscard]] inline Pair greatest(Pair a, Pair b) {
#ifdef __SSE2__
  return std::bit_cast<Pair>(_mm_max_pd(b, a));
#else
  return a < b ? b : a;
#endif
}

}  // namespace pardel::engine
