// A temporary folder.
#pragma once

#include <filesystem>

#include "../../core/result.hpp"

namespace pardel::harness {

/// make() creates it in the system's folder for temporary files; the destructor removes it with its contents.
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

/// Creates a folder if it does not exist. An error if files cannot be created in it.
[[nodiscard]] Status make_folder(const std::filesystem::path& folder);

}  // namespace pardel::harness
