// The register of known mistakes: properties/mutants/registry, one line each.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pardel::mutants {

/// How a program that runs a property ends.
enum class End {
  passed,   ///< the property holds
  failed,   ///< GoogleTest says that it does not
  crashed,  ///< by a signal, or with another exit code
  timed_out,
  not_found  ///< the program has no such property
};
[[nodiscard]] const char* name(End end);

/// Of one property.
struct Killer {
  std::string program;   ///< without the suffix _mutated
  std::string property;  ///< SUITE.NAME
  friend auto operator<=>(const Killer&, const Killer&) = default;
};

struct Mutant {
  std::string name;       ///< as mutated() asks for it
  std::string file;       ///< in which it does, from the project's root
  std::string mistake;    ///< what is spoiled, for people
  Killer killer;          ///< what has to notice it
  End end = End::failed;  ///< in this way
};

/// The columns are separated by " | ": name, file, mistake, program and property (separated by a space), and, where
/// the mutant does not end in a failed assertion, "crashed" or "timed out". Blank lines and lines that begin with #
/// say nothing. Throws std::runtime_error for a line that is none of this.
[[nodiscard]] std::vector<Mutant> read_registry(const std::filesystem::path& file);

}  // namespace pardel::mutants
