#include "work_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace pardel {

namespace fs = std::filesystem;

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

Status WorkFolder::make(const std::string& prefix) {
  std::error_code error;
  std::string name = (fs::temp_directory_path(error) / (prefix + "-XXXXXX")).string();
  if (error) return Error{ErrorKind::io, "no folder for temporary files (TMPDIR): " + error.message()};
  if (mkdtemp(name.data()) == nullptr)
    return Error{ErrorKind::io, name + ": " + std::generic_category().message(errno)};
  path_ = name;
  return Done{};
}

}  // namespace pardel
