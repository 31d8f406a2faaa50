// Makes any bytes a text that cairo can draw.
#pragma once

#include <string>
#include <string_view>

namespace pardel::cli {

/// The text with U+FFFD in place of each byte that is not part of a character in UTF-8.
[[nodiscard]] std::string valid_utf8(std::string_view text);

}  // namespace pardel::cli
