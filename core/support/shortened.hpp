// Texts of others in messages.
#pragma once

#include <cstddef>
#include <string>

namespace pardel {

/// At most this number of bytes of a text, and "..." if some are left out. Does not cut within a UTF-8 sequence.
[[nodiscard]] inline std::string shortened(std::string text, std::size_t most = 300) {
  if (text.size() <= most) return text;
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  text.resize(end);
  return text + "...";
}

}  // namespace pardel
