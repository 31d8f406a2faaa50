#include "output.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "../core/formats.hpp"
#include "../core/support/output_file.hpp"

namespace pardel::cli {
namespace fs = std::filesystem;
namespace {

Error io_error(const fs::path& file, int error) {
  return {ErrorKind::io, fmt::format("{}: {}", file.string(), std::strerror(error))};
}

/// True for devices, for pipes and for names like /dev/stdout. These cannot be replaced by a finished file.
bool written_in_place(const fs::path& file) {
  std::error_code ignored;
  const std::string name = file.lexically_normal().string();
  return name.starts_with("/dev/") || name.starts_with("/proc/") ||
         (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored));
}

/// Returns the same path for all files that are read or written together, such as Triangle's files with one stem.
fs::path family(const fs::path& file) {
  std::error_code ignored;
  fs::path full = fs::weakly_canonical(fs::absolute(file, ignored), ignored);
  if (full.empty()) full = file;
  constexpr std::array together = {".poly", ".node", ".ele", ".area"};
  for (const char* suffix : together) {
    if (full.extension() == suffix) return full.replace_extension();
  }
  return full;
}

}  // namespace

Status write_text(std::string_view text, const fs::path& file) {
  if (file == "-") {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) return io_error("standard output", errno);
    return Done{};
  }
  OutputFile output(file);
  output.write(text);
  return output.commit();
}

Status check_folder(const fs::path& file) {
  if (file.empty() || file == "-") return Done{};
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) return io_error(file, EISDIR);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (access(folder.c_str(), F_OK) != 0) return io_error(file, errno);
  if (!fs::is_directory(folder, ignored)) return io_error(file, ENOTDIR);
  if (access(written_in_place(file) ? file.c_str() : folder.c_str(), W_OK) != 0) return io_error(file, errno);
  return Done{};
}

Status check_poly_output(const fs::path& file) {
  if (file.extension() != ".poly" && !written_in_place(file)) {
    return Error{ErrorKind::usage, fmt::format("{}: domains are written as .poly", file.string())};
  }
  return check_folder(file);
}

Status check_mesh_outputs(std::span<const fs::path> outputs, std::span<const fs::path> inputs) {
  for (const fs::path& output : outputs) {
    if (!is_mesh_suffix(output)) {
      return Error{ErrorKind::usage,
                   fmt::format("{}: the suffix sets the format and must be one of .node .ele .vtu .msh .off .svg",
                               output.string())};
    }
    for (const fs::path& input : inputs) {
      if (family(output) == family(input)) {
        return Error{ErrorKind::usage,
                     fmt::format("{}: this output would replace files of the input {}; choose another name",
                                 output.string(), input.string())};
      }
    }
    if (Status folder = check_folder(output); !folder) return folder;
  }
  return Done{};
}

}  // namespace pardel::cli
