// A temporary folder.
#pragma once

#include <filesystem>
#include <string>

#include "../result.hpp"

namespace pardel {

/// make() creates the folder in the system's folder for temporary files. The destructor removes it with its contents;
/// so does a process that ends early, unless it is killed (short_lived.hpp).
class WorkFolder {
 public:
  WorkFolder() = default;
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  /// The name of the folder begins with `prefix`; no other folder has this name. Error: `io`.
  [[nodiscard]] Status make(const std::string& prefix);
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace pardel
