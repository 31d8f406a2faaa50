// Programs by name: where a shell would find them.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace pardel::cli {

/// True for a file that may be executed.
[[nodiscard]] inline bool is_program(const std::filesystem::path& file) {
  std::error_code ignored;
  return access(file.c_str(), X_OK) == 0 && !std::filesystem::is_directory(file, ignored);
}

/// The program's absolute path, or an empty path if it is not on the PATH.
[[nodiscard]] inline std::filesystem::path on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  const std::string folders = path != nullptr ? path : "";
  for (std::size_t start = 0; start <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', start), folders.size());
    const std::filesystem::path candidate = std::filesystem::path(folders.substr(start, end - start)) / program;
    if (is_program(candidate)) return std::filesystem::absolute(candidate);
    start = end + 1;
  }
  return {};
}

}  // namespace pardel::cli
