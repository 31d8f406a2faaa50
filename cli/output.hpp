// Files that the program writes, and whether they can be hoped for before the work starts.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "../core/result.hpp"

namespace pardel::cli {

/// "-" is standard output. A regular file appears under its name only when it is complete.
[[nodiscard]] Status write_text(std::string_view text, const std::filesystem::path& file);

/// Refuses what is bound to fail or to harm, before any work is done: an unknown suffix (usage), an output
/// that would replace one of the inputs (usage), a folder that does not exist or may not be written (io).
[[nodiscard]] Status check_mesh_outputs(std::span<const std::filesystem::path> outputs,
                                        std::span<const std::filesystem::path> inputs);
/// A domain is written as .poly (or to a device); any other suffix would mislead whoever reads it: usage.
[[nodiscard]] Status check_poly_output(const std::filesystem::path& file);
/// That the folder of a file exists and may be written (io); "-" and "" are fine.
[[nodiscard]] Status check_folder(const std::filesystem::path& file);

}  // namespace pardel::cli
