// Random numbers that are the same on every platform.
#pragma once

#include "../../../core/support/hash.hpp"

namespace pardel::schemes {

/// The number that SplitMix64 draws in this state (Steele, Lea, Flood 2014). A bijection.
[[nodiscard]] constexpr std::uint64_t random_number(std::uint64_t state) { return mixed(state + 0x9e3779b97f4a7c15U); }

}  // namespace pardel::schemes
