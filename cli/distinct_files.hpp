// A check that no output of a command replaces another file of the same command.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "../core/result.hpp"

namespace pardel::cli {

/// A file of the command line.
struct NamedFile {
  std::string option;  ///< of an output, for messages: "-o"
  std::filesystem::path file;
  /// True if all of Triangle's files with the same stem (.poly, .node, .ele, .area) are read or written with a file
  /// that has one of these suffixes.
  bool with_family = true;
};

/// Error: `usage` if an output is the file of another output, or of an input, under any spelling of its path. An input
/// that is a mesh in pieces stands for the files of the pieces, too. Empty names, standard output and character devices
/// such as /dev/null are skipped.
[[nodiscard]] Status check_distinct(std::span<const NamedFile> outputs, std::span<const NamedFile> inputs);

/// A domain that is read: a .poly may belong together with a .node, but a .node is read alone.
[[nodiscard]] NamedFile domain_input(const std::filesystem::path& file);

}  // namespace pardel::cli
