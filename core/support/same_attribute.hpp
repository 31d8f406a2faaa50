// Equality of attributes, which may be any numbers.
#pragma once

namespace pardel {

/// True if the numbers are equal, or if neither is a number.
[[nodiscard]] constexpr bool is_same_attribute(double a, double b) { return a == b || (a != a && b != b); }

}  // namespace pardel
