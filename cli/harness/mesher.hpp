// The program under test: a command line with placeholders for file names and bounds.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "../../core/goal.hpp"
#include "../../core/result.hpp"

namespace pardel::harness {

struct Mesher {
  std::vector<std::string> words;     ///< words[0] is the path of the program
  std::string suffix;                 ///< suffix of the output file: "ele", "vtu", "msh" or "off"
  std::vector<int> success_codes{0};  ///< exit codes that mean: a mesh was written
  std::string title;                  ///< for the report: the command of the user or of the adaptor
};

/// Finds a mesher. `command` is either the name of an adaptor ("pardel", "cgal", "gmsh", "triangle"), whose program
/// must be in the folder of pardel-harness, or a command line that split_words() splits. `suffix`: the format that a
/// command line writes; an adaptor has its own. `with_area`: the goal has an area bound. Errors: `io` if the program
/// does not exist, `usage` if the command line has no {poly}.
[[nodiscard]] Result<Mesher> find_mesher(const std::string& command, const std::string& suffix, bool with_area);

/// The adaptors with their commands, one per line.
[[nodiscard]] std::string adaptors_text();

/// The command for one case: replaces {poly}, {out}, {min-angle}, {max-area}. Numbers are exact and have no exponents.
[[nodiscard]] std::vector<std::string> command(const Mesher& mesher, const std::filesystem::path& poly,
                                               const std::filesystem::path& out, const Goal& goal);

}  // namespace pardel::harness
