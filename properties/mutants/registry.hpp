// Reads the list of known mistakes, properties/mutants/registry.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pardel::mutants {

/// The end of the run of one property in a test program.
enum class End {
  passed,     ///< the property holds
  failed,     ///< GoogleTest reports that the property fails
  crashed,    ///< the run ended in any other way, for example by a signal
  timed_out,  ///< the time limit ended the program
  not_found   ///< the program has no such property
};
[[nodiscard]] const char* name(End end);

/// The property that must fail when a mutant is switched on.
struct Killer {
  std::string program;   ///< the test program, without the suffix _mutated
  std::string property;  ///< SUITE.NAME
  friend auto operator<=>(const Killer&, const Killer&) = default;
};

struct Mutant {
  std::string name;       ///< the value of PARDEL_MUTANT that switches the mutant on
  std::string file;       ///< the source file that the mutant changes, relative to the project's root
  std::string mistake;    ///< a description for the reader
  Killer killer;          ///< the property that must fail
  End end = End::failed;  ///< how the killer's run must end
};

/// Reads a registry: one mutant per line, in columns separated by " | ". The columns are the name, the source file, the
/// mistake, and the killer (program and property, separated by a space). If the killer's run does not end with a failed
/// assertion, there is a fifth column, "crashed" or "timed out". Blank lines and lines that begin with # are ignored.
/// Throws std::runtime_error if the file cannot be read or a line is not of this form.
[[nodiscard]] std::vector<Mutant> read_registry(const std::filesystem::path& file);

}  // namespace pardel::mutants
