#include "work_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <mutex>
#include <system_error>

#include "partial_files.hpp"
#include "short_lived.hpp"

namespace pardel {

namespace fs = std::filesystem;

WorkFolder::~WorkFolder() {
  if (!path_.empty()) ShortLived::of_process().remove_folder(path_);
}

Status WorkFolder::make(const std::string& prefix) {
  std::error_code error;
  std::string name = (fs::temp_directory_path(error) / (prefix + "-XXXXXX")).string();
  if (error) return Error{ErrorKind::io, "no folder for temporary files (TMPDIR): " + error.message()};
  const std::scoped_lock lock(PartialFiles::of_process().mutex);  // so that no folder is made that is not on the list
  if (mkdtemp(name.data()) == nullptr)
    return Error{ErrorKind::io, name + ": " + std::generic_category().message(errno)};
  path_ = name;
  ShortLived::of_process().add_folder(path_);
  return Done{};
}

}  // namespace pardel
