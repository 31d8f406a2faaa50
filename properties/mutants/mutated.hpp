// The switches of the mutants. A mutated twin is a test program that is built from a copy of the sources with all
// mutants. The sources of the copy that contain mutants include this file; no other code uses it.
#pragma once

#include <cstdlib>
#include <string_view>

namespace pardel {

/// The mutant that the environment variable PARDEL_MUTANT names. Empty if the variable is not set.
[[nodiscard]] inline std::string_view chosen_mutant() {
  static const std::string_view chosen = [] {
    const char* name = std::getenv("PARDEL_MUTANT");
    return name == nullptr ? std::string_view() : std::string_view(name);
  }();
  return chosen;
}

/// True if this mutant is switched on.
[[nodiscard]] inline bool mutated(std::string_view mutant) { return mutant == chosen_mutant(); }

/// True if this member of a family is switched on. A mutant's name is the family's name followed by the member's name.
[[nodiscard]] inline bool mutated(std::string_view family, std::string_view member) {
  const std::string_view chosen = chosen_mutant();
  return chosen.starts_with(family) && chosen.substr(family.size()) == member;
}

}  // namespace pardel
