// How many faults a test makes.
#pragma once

#include <cstdint>
#include <vector>

namespace pardel::testing {

/// Numbers from 1 to `all`: all of them if there are at most `usual`. Otherwise one number of each of `usual` equal
/// parts, chosen at random. The environment variable PARDEL_FAULT_CASES replaces `usual`, and PARDEL_FAULT_SEED the
/// seed 1. In ascending order.
[[nodiscard]] std::vector<std::uint64_t> selection(std::uint64_t all, std::uint64_t usual);

/// The value of PARDEL_FAULT_CASES, or `usual`.
[[nodiscard]] std::uint64_t fault_cases(std::uint64_t usual);
/// The value of PARDEL_FAULT_SEED, or 1.
[[nodiscard]] std::uint64_t fault_seed();

}  // namespace pardel::testing
