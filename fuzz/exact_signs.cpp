#include "exact_signs.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pardel::fuzz {
namespace {

using Whole = mpz_class;

/// A double is mantissa * 2^exponent.
struct Parts {
  std::int64_t mantissa = 0;
  int exponent = std::numeric_limits<int>::max();  ///< of zero: larger than all others

  explicit Parts(double x) {
    if (x == 0) return;
    int of_fraction = 0;
    mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &of_fraction), 53));
    exponent = of_fraction - 53;
  }
};

/// The points times a power of two that makes all coordinates whole numbers: x of the first point, y, x of the second.
template <std::size_t N>
std::array<Whole, 2 * N> whole(const std::array<Point, N>& points) {
  std::array<Parts, 2 * N> parts = [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array{Parts(I % 2 == 0 ? points[I / 2].x : points[I / 2].y)...};
  }
  (std::make_index_sequence<2 * N>());
  const int least = std::ranges::min(parts, {}, &Parts::exponent).exponent;
  std::array<Whole, 2 * N> result;
  for (std::size_t i = 0; i < 2 * N; ++i) {
    if (parts[i].mantissa == 0) continue;
    result[i] = static_cast<long>(parts[i].mantissa);
    result[i] <<= static_cast<mp_bitcnt_t>(parts[i].exponent - least);
  }
  return result;
}

}  // namespace

int true_orientation(Point a, Point b, Point c) {
  const auto p = whole<3>({a, b, c});
  const Whole ax = p[0] - p[4], ay = p[1] - p[5], bx = p[2] - p[4], by = p[3] - p[5];
  const Whole left = ax * by, right = ay * bx;
  return cmp(left, right) > 0 ? 1 : cmp(left, right) < 0 ? -1 : 0;
}

int true_incircle(Point a, Point b, Point c, Point d) {
  const auto p = whole<4>({a, b, c, d});
  const Whole ax = p[0] - p[6], ay = p[1] - p[7], bx = p[2] - p[6], by = p[3] - p[7], cx = p[4] - p[6],
              cy = p[5] - p[7];
  const Whole a2 = ax * ax + ay * ay, b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const Whole determinant = ax * (by * c2 - b2 * cy) - ay * (bx * c2 - b2 * cx) + a2 * (bx * cy - by * cx);
  return sgn(determinant);
}

}  // namespace pardel::fuzz
