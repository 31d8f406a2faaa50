// Random numbers: SplitMix64, the same sequence on every platform. All random inputs of the project come from it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pardel::generators {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// 64 random bits.
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111eb;
    return z ^ (z >> 31U);
  }
  /// An integer in [0, n). Precondition: n > 0. (Larger values are rarer by a factor of up to 1 - n / 2^64.)
  std::size_t below(std::size_t n) { return next() % n; }
  /// An integer in [low, high]. Precondition: low <= high.
  int between(int low, int high) { return low + static_cast<int>(below(static_cast<std::size_t>(high - low) + 1)); }
  /// True with probability 1 / one_in. Precondition: one_in > 0.
  bool chance(int one_in) { return below(static_cast<std::size_t>(one_in)) == 0; }
  /// A number in [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(next() >> 11U) * 0x1p-53; }
  /// A number in [low, high), up to rounding.
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// A random element of `values`. Precondition: `values` is not empty.
  template <class T>
  const T& one_of(const std::vector<T>& values) {
    return values[below(values.size())];
  }
  /// Puts the values into random order. Every order is equally likely, up to the bias of below().
  template <class T>
  void shuffle(std::vector<T>& values) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[below(i)]);
  }

 private:
  std::uint64_t state_;
};

}  // namespace pardel::generators
