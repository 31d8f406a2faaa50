#include "kept_file.hpp"

#include <system_error>

#include "partial_files.hpp"

namespace pardel {

namespace fs = std::filesystem;

KeptFile::KeptFile(const fs::path& file) : file_(file) {
  std::error_code ignored;
  existed_ = fs::exists(fs::symlink_status(file_, ignored));
  if (!existed_) return;
  kept_ = PartialFiles::of_process().make(file_, [&](const fs::path& name) {
    std::error_code error;
    fs::create_hard_link(file_, name, error);
    return error.value();
  });
}

KeptFile::~KeptFile() {
  PartialFiles& partial = PartialFiles::of_process();
  const std::scoped_lock lock(partial.mutex);
  std::error_code failure;
  if (is_changed_ && (!existed_ || !kept_.empty())) {
    // Why the new file is not wanted may be that a file could not be linked, or renamed. So both ways are tried.
    fs::remove(file_, failure);
    if (existed_) fs::create_hard_link(kept_, file_, failure);
    if (existed_ && failure) fs::rename(kept_, file_, failure);
  }
  if (kept_.empty()) return;
  if (failure)
    partial.forget(kept_);  // the old file stays under its other name
  else
    partial.remove(kept_);
}

}  // namespace pardel
