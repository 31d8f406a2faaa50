// The patches that add the mutants (known mistakes that can be switched on) to a copy of the sources.
//
// properties/mutants/patches/NAME.patch holds the mutant NAME of the registry. If NAME ends with an underscore, the
// patch holds a family: all mutants of the registry whose names begin with NAME. The first line of a patch is the path
// of the source file, relative to the project's root. Hunks follow, separated by lines "@@". A hunk is a list of lines
// as in a unified diff, without line numbers: " " marks context, "-" a line that is removed, "+" a line that is added.
// The context and the removed lines together must occur exactly once in the source file. The added lines contain the
// mutant's switch, mutated("NAME") (mutated.hpp), so that one build holds all mutants.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pardel::mutants {

using Lines = std::vector<std::string>;

struct Hunk {
  Lines old_lines;  ///< context and removed lines
  Lines new_lines;  ///< context and added lines
};

struct Patch {
  std::string name;               ///< of the mutant, or of the family
  std::filesystem::path file;     ///< the patch itself, for messages
  std::filesystem::path changes;  ///< the source file, relative to the project's root
  std::vector<Hunk> hunks;
};

/// Reads a patch; its name is the file's name without ".patch". Throws std::runtime_error if a line begins with another
/// character, a hunk has neither context nor removed lines, or no added line contains the mutant's switch.
[[nodiscard]] Patch read_patch(const std::filesystem::path& file);

/// Applies all hunks of the patch, each to the result of the one before it. Throws std::runtime_error if the old lines
/// of a hunk do not occur exactly once.
[[nodiscard]] Lines patched(const Patch& patch, Lines text);

/// Copies the C++ files (*.hpp, *.cpp) below the given folders of `root` to the same paths in `copy`, with the patches
/// in root/properties/mutants/patches applied in the order of root/properties/mutants/registry. The sources that have
/// patches include root/properties/mutants/mutated.hpp in a new first line. Writes only the files whose text changes.
/// Removes the C++ files below the same folders of `copy` that no longer exist in `root`. If a patch is wrong, it
/// changes nothing and returns one line for each patch that does not apply, each mutant without a patch and each patch
/// without a mutant.
[[nodiscard]] std::vector<std::string> copy_with_mutants(const std::filesystem::path& root,
                                                         const std::vector<std::string>& folders,
                                                         const std::filesystem::path& copy);

}  // namespace pardel::mutants
