// Output files: writing text, and checks that find a hopeless output before the work starts.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "../core/result.hpp"

namespace pardel::cli {

/// "-" is standard output. A regular file appears under its name only when it is complete.
[[nodiscard]] Status write_text(std::string_view text, const std::filesystem::path& file);

/// Errors: `usage` for an unknown suffix, or an output that would replace one of the inputs; `io` for a folder that
/// does not exist or is not writable.
[[nodiscard]] Status check_mesh_outputs(std::span<const std::filesystem::path> outputs,
                                        std::span<const std::filesystem::path> inputs);
/// Errors: `usage` where the suffix is not .poly (except for a device); `io` as above.
[[nodiscard]] Status check_poly_output(const std::filesystem::path& file);
/// Error: `io` where the folder of the file does not exist or is not writable. "-" and "" are accepted.
[[nodiscard]] Status check_folder(const std::filesystem::path& file);

}  // namespace pardel::cli
