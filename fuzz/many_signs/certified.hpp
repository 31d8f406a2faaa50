// Signs from arithmetic with 64 binary digits, if they are certain. Each number knows a bound on its error, which every
// operation carries on; so the bound needs no analysis of a whole formula. It shares nothing with the filters of the
// mesher and of the checker, and is for the many calls that exact arithmetic would make slow.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "../../core/pslg.hpp"

namespace pardel::fuzz {

/// A real number r with |r - value| <= error.
struct Bounded {
  // An operation rounds by at most one unit in the last place. The factor also covers the rounding of the error itself,
  // which has at most five operations. No underflow: coordinates are zero or between 2^-140 and 2^200.
  static constexpr long double unit = std::numeric_limits<long double>::epsilon();
  static constexpr long double slack = 1 + 16 * unit;

  long double value = 0, error = 0;

  friend Bounded operator+(Bounded a, Bounded b) {
    const long double sum = a.value + b.value;
    return {sum, (a.error + b.error + std::fabs(sum) * unit) * slack};
  }
  friend Bounded operator-(Bounded a, Bounded b) { return a + Bounded{-b.value, b.error}; }
  friend Bounded operator*(Bounded a, Bounded b) {
    const long double product = a.value * b.value;
    return {product, (std::fabs(a.value) * b.error + std::fabs(b.value) * a.error + a.error * b.error +
                      std::fabs(product) * unit) *
                         slack};
  }
  /// The sign, if it is certain.
  [[nodiscard]] std::optional<int> sign() const {
    if (std::fabs(value) > error) return value > 0 ? 1 : -1;
    if (value == 0 && error == 0) return 0;
    return std::nullopt;
  }
};

struct BoundedPoint {
  Bounded x, y;
  BoundedPoint(Point p, Point origin)
      : x(Bounded{p.x, 0} - Bounded{origin.x, 0}), y(Bounded{p.y, 0} - Bounded{origin.y, 0}) {}
};

[[nodiscard]] inline std::optional<int> certain_orientation(Point a, Point b, Point c) {
  const BoundedPoint p(a, c), q(b, c);
  return (p.x * q.y - p.y * q.x).sign();
}

[[nodiscard]] inline std::optional<int> certain_incircle(Point a, Point b, Point c, Point d) {
  const BoundedPoint p(a, d), q(b, d), r(c, d);
  const Bounded pq = p.x * q.y - p.y * q.x, qr = q.x * r.y - q.y * r.x, rp = r.x * p.y - r.y * p.x;
  return ((p.x * p.x + p.y * p.y) * qr + (q.x * q.x + q.y * q.y) * rp + (r.x * r.x + r.y * r.y) * pq).sign();
}

}  // namespace pardel::fuzz
