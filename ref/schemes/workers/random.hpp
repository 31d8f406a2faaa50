// Random numbers that are the same on every platform.
#pragma once

#include <cstdint>

namespace pardel::schemes {

/// Mixes the bits of a number (the finaliser of SplitMix64: Steele, Lea, Flood 2014). A bijection.
[[nodiscard]] constexpr std::uint64_t mixed(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111eb;
  return z ^ (z >> 31U);
}

}  // namespace pardel::schemes
