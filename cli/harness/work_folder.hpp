// A temporary folder.
#pragma once

#include <filesystem>

#include "../../core/result.hpp"

namespace pardel::harness {

/// make() creates the folder in the system's folder for temporary files. The destructor removes it with its contents.
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

/// Creates the folder if it does not exist. Returns an error if no files can be created in it.
[[nodiscard]] Status make_folder(const std::filesystem::path& folder);

}  // namespace pardel::harness
