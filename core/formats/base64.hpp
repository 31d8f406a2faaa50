// The base64 encoding, as VTK and other programs write it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pardel::files {

/// Decodes base64 until there are `most` bytes or a character is not base64. Padding ends a group of four characters,
/// but not the text: some writers encode the length and the data separately, and pad both.
[[nodiscard]] std::string decode_base64(std::string_view text, std::size_t most);

}  // namespace pardel::files
