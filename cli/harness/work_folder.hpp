// A folder for files that do not last.
#pragma once

#include <filesystem>

#include "../../core/result.hpp"

namespace pardel::harness {

/// Made below the system's folder for such things; gone, with all that is in it, at the end.
class WorkFolder {
 public:
  WorkFolder() = default;
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  [[nodiscard]] Status make();
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Makes a folder, unless it exists, and tries whether files can be made in it.
[[nodiscard]] Status make_folder(const std::filesystem::path& folder);

}  // namespace pardel::harness
