// Numbers as text, so that they read back to the same value.
#pragma once

#include <array>
#include <charconv>
#include <string>

#include "../core/pslg.hpp"

namespace pardel {

template <class Number>
[[nodiscard]] std::string to_text(Number value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return {digits.data(), end.ptr};
}

[[nodiscard]] inline std::string to_text(Point p) { return "(" + to_text(p.x) + ", " + to_text(p.y) + ")"; }

}  // namespace pardel
