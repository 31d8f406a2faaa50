// Expands data that zlib compressed.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pardel::files {

/// Expands `compressed` and appends the result to `to`. Returns false if it is not a complete zlib stream of exactly
/// `size` bytes. A wrong size cannot cost more memory than zlib's largest ratio, about 1 : 1032, allows.
[[nodiscard]] bool append_expanded(std::string_view compressed, std::size_t size, std::string& to);

}  // namespace pardel::files
