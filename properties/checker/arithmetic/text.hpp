// Numbers and points as text, for messages and certificates.
#pragma once

#include <concepts>
#include <string>

#include "../../../core/pslg.hpp"

namespace pardel::checker {

/// The shortest decimal text from which the same value can be read back. A point becomes "(x, y)".
[[nodiscard]] std::string to_text(long long value);
[[nodiscard]] std::string to_text(unsigned long long value);
[[nodiscard]] std::string to_text(double value);
[[nodiscard]] std::string to_text(Point p);

[[nodiscard]] std::string to_text(std::signed_integral auto value) { return to_text(static_cast<long long>(value)); }
[[nodiscard]] std::string to_text(std::unsigned_integral auto value) {
  return to_text(static_cast<unsigned long long>(value));
}

/// Six significant digits.
[[nodiscard]] std::string to_short_text(double value);

}  // namespace pardel::checker
