// The byte order mark that some editors put at the beginning of a text in UTF-8.
#pragma once

#include <string_view>

namespace pardel {

inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// The text without a byte order mark at the beginning.
[[nodiscard]] constexpr std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return text;
}

}  // namespace pardel
