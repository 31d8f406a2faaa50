#include "output.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "../core/formats.hpp"
#include "../core/output_file.hpp"

namespace pardel::cli {
namespace fs = std::filesystem;
namespace {

Error io_error(const fs::path& file, int error) {
  return {ErrorKind::io, fmt::format("{}: {}", file.string(), std::strerror(error))};
}

/// What a file stands for: Triangle's files of one stem belong together.
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
  // What is no regular file is written in place and needs no room in the folder.
  const bool in_place = fs::exists(file, ignored) && !fs::is_regular_file(file, ignored);
  if (access(in_place ? file.c_str() : folder.c_str(), W_OK) != 0) return io_error(file, errno);
  return Done{};
}

Status check_mesh_outputs(std::span<const fs::path> outputs, std::span<const fs::path> inputs) {
  for (const fs::path& output : outputs) {
    if (!is_mesh_suffix(output)) {
      return Error{
          ErrorKind::usage,
          fmt::format("{}: the format follows the suffix, which has to be one of .node .ele .vtu .msh .off .svg",
                      output.string())};
    }
    for (const fs::path& input : inputs) {
      if (family(output) == family(input)) {
        return Error{ErrorKind::usage, fmt::format("{}: would replace files of the input {}; choose another name",
                                                   output.string(), input.string())};
      }
    }
    if (Status folder = check_folder(output); !folder) return folder;
  }
  return Done{};
}

}  // namespace pardel::cli
