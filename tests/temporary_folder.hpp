// A new folder for a test that reads and writes files. The destructor removes the folder with its contents.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace pardel {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    // ctest runs each test in its own process; the counter distinguishes the folders of one process.
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("pardel-test-folder-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directory(path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(std::string_view name) const { return path_ / name; }

  /// Writes a file. Creates the folders in `name` if they do not exist.
  std::filesystem::path write(std::string_view name, std::string_view content) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << content;
    return path_ / name;
  }
  [[nodiscard]] std::string read(std::string_view name) const {
    std::ifstream in(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  /// The sorted names of the files in the folder, each followed by a blank: "a.ele a.node ".
  [[nodiscard]] std::string names() const {
    std::vector<std::string> sorted;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) sorted.push_back(entry.path().filename());
    std::sort(sorted.begin(), sorted.end());
    std::string all;
    for (const std::string& name : sorted) all += name + " ";
    return all;
  }

 private:
  std::filesystem::path path_;
};

/// The error message of `result`, with file names relative to `folder`; "(no error)" if `result` is not an error.
template <class T>
std::string message_of(const T& result, const TemporaryFolder& folder) {
  if (result.ok()) return "(no error)";
  std::string message = result.error().message;
  const std::string prefix = (folder / "").string();
  for (std::size_t at = message.find(prefix); at != std::string::npos; at = message.find(prefix)) {
    message.erase(at, prefix.size());
  }
  return message;
}

}  // namespace pardel
