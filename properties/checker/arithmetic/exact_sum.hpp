// ExactSum: sums of products of doubles without any rounding, so that areas of whole meshes can be
// compared for equality. A fixed-point number wide enough for every finite product of two doubles
// (Kulisch's long accumulator).
#pragma once

#include <array>
#include <cstdint>

#include "../../../core/pslg.hpp"

namespace pardel::checker {

class ExactSum {
 public:
  /// Adds x * y (finite), or subtracts it. Constant time.
  void add_product(double x, double y) { accumulate(x, y, false); }
  void subtract_product(double x, double y) { accumulate(x, y, true); }

  /// Adds a x b = a.x b.y - a.y b.x: summed over the edges of a closed polygon it gives twice its area.
  void add_cross(Point a, Point b) {
    add_product(a.x, b.y);
    subtract_product(a.y, b.x);
  }

  ExactSum& operator+=(const ExactSum& other);
  ExactSum& operator-=(const ExactSum& other);

  /// -1, 0 or +1: the exact sign.
  [[nodiscard]] int sign() const;
  /// The value within a relative error of 2^-50 (infinite where it exceeds every double).
  [[nodiscard]] double rounded() const;

 private:
  // Limb i counts units of 2^(32 i - 2148); 2148 = 2 * 1074 is where the product of the two least doubles
  // ends. Products end below 2^2048, and 64 more bits hold the sum of any number of them that fits memory.
  static constexpr int bits_per_limb = 32;
  static constexpr int lowest_exponent = -2148;
  static constexpr int limbs = (2148 + 2048 + 64) / bits_per_limb + 2;

  void accumulate(double x, double y, bool subtract);
  /// Brings every limb but the last into [0, 2^32); the last one keeps the sign.
  void carry();

  std::array<std::int64_t, limbs> limb_{};
  std::uint32_t pending_ = 0;  ///< additions since the last carry
};

}  // namespace pardel::checker
