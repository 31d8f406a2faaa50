// A folder for the files of a benchmark.
#pragma once

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace pardel::workloads {

/// A new folder in $TMPDIR or /tmp, which the destructor removes with its files.
class TemporaryFolder {
 public:
  /// Throws std::system_error if the folder cannot be made.
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "pardel-benchmark-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::system_error(errno, std::generic_category(), name);
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace pardel::workloads
