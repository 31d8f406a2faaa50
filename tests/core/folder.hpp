// A folder of its own for a test that reads and writes files, removed with all it holds.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace pardel {

class Folder {
 public:
  Folder() {
    // ctest runs each test in a process of its own; within one process the counter tells folders apart.
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("pardel-core-test-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directory(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }

  std::filesystem::path operator/(std::string_view name) const { return path_ / name; }

  std::filesystem::path write(std::string_view name, std::string_view content) const {
    std::ofstream(path_ / name, std::ios::binary) << content;
    return path_ / name;
  }
  [[nodiscard]] std::string read(std::string_view name) const {
    std::ifstream in(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  /// The names in it, sorted, one after the other: "a.ele a.node ".
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

/// The message of a result that must be an error of this kind, without the folder's part of file names.
template <class T>
std::string message_of(const T& result, const Folder& folder) {
  if (result.ok()) return "(no error)";
  std::string message = result.error().message;
  const std::string prefix = (folder / "").string();
  for (std::size_t at = message.find(prefix); at != std::string::npos; at = message.find(prefix)) {
    message.erase(at, prefix.size());
  }
  return message;
}

}  // namespace pardel
