// Two doubles that go through the same arithmetic together: every processor that this runs on has instructions for
// that, and compilers have the type. Each half is rounded as a double by itself is, so results do not depend on it.
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
/// What a comparison of two pairs says: for each half, all bits or none.
using PairBits __attribute__((vector_size(2 * sizeof(std::int64_t)))) = std::int64_t;

/// A point's coordinates.
[[nodiscard]] inline Pair as_pair(const Point& p) { return std::bit_cast<Pair>(p); }
[[nodiscard]] inline Point as_point(Pair p) { return std::bit_cast<Point>(p); }
[[nodiscard]] inline Pair firsts(Pair a, Pair b) { return __builtin_shufflevector(a, b, 0, 2); }
[[nodiscard]] inline Pair seconds(Pair a, Pair b) { return __builtin_shufflevector(a, b, 1, 3); }

/// What a comparison says of the first half in bit 0, of the second in bit 1.
[[nodiscard]] inline unsigned bits(PairBits says) {
#ifdef __SSE2__
  return static_cast<unsigned>(_mm_movemask_pd(std::bit_cast<Pair>(says)));
#else
  return static_cast<unsigned>((says[0] & 1) | (says[1] & 2));
#endif
}

// The same names for one double and for two, so that a template may do either.
[[nodiscard]] inline bool all(bool says) { return says; }
[[nodiscard]] inline bool all(PairBits says) { return bits(says) == 3; }
[[nodiscard]] inline double magnitude(double a) { return std::abs(a); }
[[nodiscard]] inline Pair magnitude(Pair a) {
  return std::bit_cast<Pair>(std::bit_cast<PairBits>(a) & std::int64_t{0x7fff'ffff'ffff'ffff});
}
[[nodiscard]] inline double least(double a, double b) { return std::min(a, b); }
[[nodiscard]] inline Pair least(Pair a, Pair b) { return b < a ? b : a; }
[[nodiscard]] inline double greatest(double a, double b) { return std::max(a, b); }
[[nodiscard]] inline Pair greatest(Pair a, Pair b) { return a < b ? b : a; }

}  // namespace pardel::engine
