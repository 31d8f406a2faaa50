// The suffixes of file names, which set the formats.
#pragma once

#include <filesystem>

#include "../core/result.hpp"

namespace pardel::cli {

/// True for .poly and .node, and for a name without a suffix, such as /dev/stdin, which is read as a .poly.
[[nodiscard]] bool is_domain_suffix(const std::filesystem::path& file);

/// The error for a file whose format is not known. `content`: "a mesh". `known`: the list of suffixes.
[[nodiscard]] Error unknown_format(const std::filesystem::path& file, const char* content, const char* known);

}  // namespace pardel::cli
