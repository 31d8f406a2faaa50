// Every fuzz target defines fuzz_one(). libFuzzer calls it (preset fuzz), and so does the replay program on the
// committed corpus, which ctest runs in every build.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace pardel::fuzz {

/// Checks the property on one input. Returns 0 where it holds, and -1 where the input is not worth keeping in a corpus.
/// Where the property fails, calls fail().
int fuzz_one(std::span<const std::uint8_t> bytes);

/// Prints the explanation to stderr and aborts, which a fuzzer counts as a finding.
[[noreturn]] void fail(std::string_view explanation);

}  // namespace pardel::fuzz
