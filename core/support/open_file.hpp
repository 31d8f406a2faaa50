// File names that stand for files that the process has open.
#pragma once

#include <filesystem>
#include <optional>

namespace pardel {

/// The number of the open file that the name stands for if it is written to: 1 for `-` and /dev/stdout, 2 for
/// /dev/stderr, N for /dev/fd/N and /proc/self/fd/N. Empty for other names.
[[nodiscard]] std::optional<int> descriptor_of(const std::filesystem::path& file);

/// True for all names of standard output, such as `-` and /dev/stdout.
[[nodiscard]] bool is_standard_output(const std::filesystem::path& file);

/// True for all names of standard input, such as `-` and /dev/stdin.
[[nodiscard]] bool is_standard_input(const std::filesystem::path& file);

}  // namespace pardel
