// Numbers as text, so that they read back to the same value.
#pragma once

#include <concepts>
#include <string>

#include "../../../core/pslg.hpp"

namespace pardel::checker {

[[nodiscard]] std::string to_text(long long value);
[[nodiscard]] std::string to_text(unsigned long long value);
[[nodiscard]] std::string to_text(double value);
[[nodiscard]] std::string to_text(Point p);

[[nodiscard]] std::string to_text(std::signed_integral auto value) { return to_text(static_cast<long long>(value)); }
[[nodiscard]] std::string to_text(std::unsigned_integral auto value) {
  return to_text(static_cast<unsigned long long>(value));
}

/// Six significant digits, for people.
[[nodiscard]] std::string to_short_text(double value);

}  // namespace pardel::checker
