// Counted nouns in messages.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace pardel::cli {

/// "1 hole", "2 holes".
[[nodiscard]] inline std::string plural(std::uint64_t n, const char* noun) {
  return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
}
/// For irregular plurals: "1 vertex", "2 vertices".
[[nodiscard]] inline std::string plural(std::uint64_t n, const char* one, const char* several) {
  return fmt::format("{} {}", n, n == 1 ? one : several);
}

}  // namespace pardel::cli
