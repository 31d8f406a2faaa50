// What every fuzz target is: one function of bytes. libFuzzer calls it (preset fuzz), and so does the replay
// program over the committed corpus, which ctest runs in every build.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace pardel::fuzz {

/// Runs the property on one input. Returns 0 where it held, -1 where the bytes say nothing worth keeping in
/// a corpus; where the property failed it tells why on stderr and aborts.
int fuzz_one(std::span<const std::uint8_t> bytes);

/// Prints `story` to stderr and aborts: what a fuzzer takes for a finding.
[[noreturn]] void fail(std::string_view story);

}  // namespace pardel::fuzz
