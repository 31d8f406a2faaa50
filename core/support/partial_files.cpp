#include "partial_files.hpp"

#include "leftover_files.hpp"

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

fs::path PartialFiles::next_name(const fs::path& file) { return partial_name(file, ++made_); }

}  // namespace pardel
