#include "partial_files.hpp"

#include <unistd.h>

#include <string>

namespace pardel {

namespace fs = std::filesystem;

PartialFiles& PartialFiles::of_process() {
  static PartialFiles files;
  return files;
}

void PartialFiles::remove_all() {
  const std::scoped_lock lock(mutex);
  std::error_code ignored;
  for (const fs::path& name : names_) fs::remove(name, ignored);
  names_.clear();
}

fs::path PartialFiles::next_name(const fs::path& file) {
  fs::path name = file;
  name += "." + std::to_string(getpid()) + "-" + std::to_string(++made_) + ".partial";
  return name;
}

}  // namespace pardel
