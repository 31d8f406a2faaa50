// ExactSum: a sum of products of doubles without rounding. The checker uses it to test whether the areas of
// all triangles sum to the area within the boundary. It is a fixed-point number that is wide enough for every finite
// product of two doubles (Kulisch's long accumulator).
#pragma once

#include <array>
#include <cstdint>

#include "../../../core/pslg.hpp"

namespace pardel::checker {

class ExactSum {
 public:
  /// Adds or subtracts x * y exactly. Precondition: x and y are finite. Constant time.
  void add_product(double x, double y) { accumulate(x, y, false); }
  void subtract_product(double x, double y) { accumulate(x, y, true); }

  /// Adds a x b = a.x b.y - a.y b.x. The sum over the edges of a closed polygon is twice the polygon's area.
  void add_cross(Point a, Point b) {
    add_product(a.x, b.y);
    subtract_product(a.y, b.x);
  }

  ExactSum& operator+=(const ExactSum& other);
  ExactSum& operator-=(const ExactSum& other);

  /// The exact sign: -1, 0 or +1.
  [[nodiscard]] int sign() const;
  /// The value, with a relative error of at most 2^-50; infinite if it exceeds every double.
  [[nodiscard]] double rounded() const;

 private:
  // Limb i counts units of 2^(32 i - 2148). The square of the smallest double is 2^-2148 (2148 = 2 * 1074), and every
  // product is below 2^2048. The 64 bits above that hold the sum of as many products as a program can add.
  static constexpr int bits_per_limb = 32;
  static constexpr int lowest_exponent = -2148;
  static constexpr int limbs = (2148 + 2048 + 64) / bits_per_limb + 2;

  void accumulate(double x, double y, bool subtract);
  /// Brings every limb except the last into [0, 2^32). The last limb keeps the sign.
  void carry();

  std::array<std::int64_t, limbs> limb_{};
  std::uint32_t pending_ = 0;  ///< additions since the last carry
};

}  // namespace pardel::checker
