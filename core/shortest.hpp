// Numbers in messages.
#pragma once

#include <array>
#include <charconv>
#include <string>

#include "mutants.hpp"

namespace pardel {

/// The shortest text that reads back to the same double.
[[nodiscard]] inline std::string shortest(double value) {
  if (mutated("numbers_lose_digits")) value = static_cast<float>(value);
  std::array<char, 32> buffer;  // the longest has 24 characters
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

}  // namespace pardel
