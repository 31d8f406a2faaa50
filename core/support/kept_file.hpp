// KeptFile: a file that can be put back after it was replaced.
#pragma once

#include <filesystem>

namespace pardel {

/// Keeps a file while it is replaced or removed: under the name `FILE.PROCESS-NUMBER.partial` in the same folder, as a
/// hard link. Without forget() the destructor puts it back.
class KeptFile {
 public:
  /// Keeps the file, if there is one. Not every file system has hard links; without them nothing is put back.
  explicit KeptFile(const std::filesystem::path& file);
  KeptFile(const KeptFile&) = delete;
  KeptFile& operator=(const KeptFile&) = delete;
  ~KeptFile();

  /// To be called when another file has got the name, or the file was removed.
  void changed() { is_changed_ = true; }
  /// The file is not needed any more: what has its name now stays.
  void forget() { is_changed_ = false; }

 private:
  std::filesystem::path file_;
  std::filesystem::path kept_;  ///< its other name; empty if it has none
  bool existed_ = false;
  bool is_changed_ = false;
};

}  // namespace pardel
