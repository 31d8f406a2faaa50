// Amounts of memory as text, for messages.
#pragma once

#include <cmath>
#include <string>

#include "shortest.hpp"

namespace pardel {

/// A number of bytes in the largest unit in which it is at least 1, with two decimals: "1.5 GiB".
[[nodiscard]] inline std::string amount_of_memory(double bytes) {
  const auto in = [&](double unit, const char* name) { return shortest(std::round(bytes / unit * 100) / 100) + name; };
  if (bytes >= 0x1p30) return in(0x1p30, " GiB");
  if (bytes >= 0x1p20) return in(0x1p20, " MiB");
  return bytes >= 0x1p10 ? in(0x1p10, " KiB") : in(1, " bytes");
}

}  // namespace pardel
