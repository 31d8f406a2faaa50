#include "work_folder.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

namespace pardel::harness {

namespace fs = std::filesystem;

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

Status WorkFolder::make() {
  std::error_code error;
  std::string name = (fs::temp_directory_path(error) / "pardel-harness-XXXXXX").string();
  if (error) return Error{ErrorKind::io, "no folder for temporary files (TMPDIR): " + error.message()};
  if (mkdtemp(name.data()) == nullptr) return Error{ErrorKind::io, fmt::format("{}: {}", name, std::strerror(errno))};
  path_ = name;
  return Done{};
}

Status make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return Error{ErrorKind::io, fmt::format("{}: {}", folder.string(), error.message())};
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    return Error{ErrorKind::io, fmt::format("{}: {}", folder.string(), std::strerror(errno))};
  }
  return Done{};
}

}  // namespace pardel::harness
