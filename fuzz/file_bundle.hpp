// Several files in one sequence of bytes, for readers that read more than one file.
//
//     == mesh.node
//     3 2 0 0
//     ...
//     == mesh.ele
//     ...
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace pardel::fuzz {

struct NamedText {
  std::string name;  ///< of letters, digits, underscores and points; it does not begin with a point
  std::string text;
};

/// The files of the bytes. A line `== NAME` begins a file; the line feed before it does not belong to the file in
/// front. Bytes that do not begin in this way are one file, with the name `otherwise`.
[[nodiscard]] std::vector<NamedText> files_of(std::span<const std::uint8_t> bytes, const std::string& otherwise);

/// A folder of this process, in memory if the machine has such a folder. Its files are removed with the object. A
/// process that is ended by a find leaves them; the next process removes them, when it makes its first folder.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  void write(const NamedText& file) const;
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
  /// Removes the folders of processes that do not exist any more. Precondition: this process has no folder.
  static void remove_leftovers(const std::filesystem::path& place);
  [[nodiscard]] bool is_empty() const { return std::filesystem::is_empty(folder_); }

 private:
  std::filesystem::path folder_;
};

/// The file that a reader gets: the main file of an input. If it is a .poly that does not exist, the .node of the same
/// name, if there is one.
[[nodiscard]] std::filesystem::path file_to_read(const Scratch& scratch, const std::string& main_file);

}  // namespace pardel::fuzz
