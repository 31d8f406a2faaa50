// Numbers as text, for messages.
#pragma once

#include <array>
#include <charconv>
#include <string>

#include "../pslg.hpp"

namespace pardel {

/// The shortest text that reads back to the same double.
[[nodiscard]] inline std::string shortest(double value) {
  std::array<char, 32> buffer;  // the longest has 24 characters
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

/// The shortest text without an exponent that reads back to the same double: some programs read no exponents.
[[nodiscard]] inline std::string fixed(double value) {
  std::array<char, 1100> digits;  // the longest has 1077 characters
  return {digits.data(),
          std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed).ptr};
}

/// The coordinates of a point, for example "(0.5, 1e-9)".
[[nodiscard]] inline std::string shortest(Point p) { return "(" + shortest(p.x) + ", " + shortest(p.y) + ")"; }

}  // namespace pardel
