// Every fuzz target defines fuzz_one(). libFuzzer calls it (preset fuzz). The replay program also calls it, on the
// committed corpus; ctest runs this in every build.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace pardel::fuzz {

/// Tests the property on one input. If the property fails, calls fail(). Returns 0 if it holds, and -1 if the input is
/// not useful in a corpus.
int fuzz_one(std::span<const std::uint8_t> bytes);

/// Prints the explanation to stderr and aborts, which a fuzzer counts as a finding.
[[noreturn]] void fail(std::string_view explanation);

}  // namespace pardel::fuzz
