// The program under test: a command line with blanks for the file names and the bounds.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "../../core/goal.hpp"
#include "../../core/result.hpp"

namespace pardel::harness {

struct Mesher {
  std::vector<std::string> words;     ///< the first is the path of a program
  std::string suffix;                 ///< of what it writes: "ele", "vtu", "msh" or "off"
  std::vector<int> success_codes{0};  ///< exit codes with which it promises a mesh
  std::string title;                  ///< for the report: the command as it was given, or an adaptor's
};

/// `command` is the name of an adaptor ("pardel", "cgal", "gmsh", "triangle"), whose program is looked for beside
/// this one, or any command line, split as split_words() does. `suffix`: what the command writes (adaptors know).
/// `with_area`: the goal has an area bound. Errors: no program, no {poly} (usage).
[[nodiscard]] Result<Mesher> find_mesher(const std::string& command, const std::string& suffix, bool with_area);

/// The names of the adaptors, with what they run.
[[nodiscard]] std::string adaptors_text();

/// The command for one case. Replaces {poly}, {out}, {min-angle} and {max-area} (fixed notation, exact).
[[nodiscard]] std::vector<std::string> command(const Mesher& mesher, const std::filesystem::path& poly,
                                               const std::filesystem::path& out, const Goal& goal);

}  // namespace pardel::harness
