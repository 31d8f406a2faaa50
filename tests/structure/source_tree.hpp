// The C++ files of the repository: which file includes which, which namespaces it opens,
// and how long its classes are.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pardel::structure {

/// One line `#include "..."` or `#include <pardel/...>`.
struct Include {
  int line = 0;
  std::string target;  ///< relative to the root of the repository
};

/// A class or struct that is not inside another one.
struct Class {
  std::string name;
  int line = 0;   ///< at which it begins
  int lines = 0;  ///< how many it has
};

struct SourceFile {
  std::vector<Include> includes;
  std::vector<std::string> namespaces;  ///< in the file's order; those named `pardel` or `pardel::...` only
  std::vector<Class> classes;
};

/// The source files by path; paths are relative to the root of the repository.
using SourceTree = std::map<std::string, SourceFile>;

/// Reads every .hpp and .cpp below `root`, except those in a folder `build` or in a hidden folder directly below it.
[[nodiscard]] SourceTree read_source_tree(const std::filesystem::path& root);

}  // namespace pardel::structure
