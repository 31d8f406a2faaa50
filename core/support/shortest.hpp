// Numbers in messages.
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace pardel {

/// The shortest text that reads back to the same double.
[[nodiscard]] inline std::string shortest(double value) {
  std::array<char, 32> buffer;  // the longest has 24 characters
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

}  // namespace pardel
