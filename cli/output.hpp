// Output files: writing text, and checks that detect an unwritable output before the work starts.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "../core/formats.hpp"
#include "../core/result.hpp"
#include "mesh_format.hpp"

namespace pardel::cli {

/// True if one of the outputs is standard output, under any of its names. Then no summary may be printed there.
[[nodiscard]] bool has_standard_output(std::span<const std::filesystem::path> outputs);

/// Error: `usage` if more than one of the outputs is standard output.
[[nodiscard]] Status check_standard_output(std::span<const std::filesystem::path> outputs);

/// Writes `text` to `file`; "-" is standard output. A regular file gets its name only when it is complete.
[[nodiscard]] Status write_text(std::string_view text, const std::filesystem::path& file);

/// Checks the options of formats: --format is needed if one of the outputs is "-", and only then; --order 2 and
/// --open-boundary need outputs of a format that has such elements or boundaries.
[[nodiscard]] Status check_format_options(std::span<const std::filesystem::path> outputs,
                                          const MeshFormatOptions& options);

/// Checks output files for meshes. "-" is accepted. Errors: `usage` if a suffix is unknown; `io` if a folder does not
/// exist or is not writable.
[[nodiscard]] Status check_mesh_outputs(std::span<const std::filesystem::path> outputs);
/// Checks an output file for a domain. Errors: `usage` if the suffix is not .poly (devices are accepted); `io` as
/// above.
[[nodiscard]] Status check_poly_output(const std::filesystem::path& file);
/// Error: `io` if the folder of the file does not exist or is not writable. Names of standard output and "" are
/// accepted.
[[nodiscard]] Status check_folder(const std::filesystem::path& file);

}  // namespace pardel::cli
