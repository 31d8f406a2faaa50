// The seam at which known mistakes ("mutants") enter, to prove that the properties notice them. A mutant is an
// ordinary `if (mutated("its_name"))` beside the line that it spoils. Everywhere but in the libraries that the
// mutant runner links (their targets end in _mutated) the answer is a constant and the branch is not compiled.
#pragma once

#include <string_view>

#ifdef PARDEL_MUTANTS
#include <cstdlib>
#endif

namespace pardel {

#ifdef PARDEL_MUTANTS

inline constexpr bool mutants_are_compiled_in = true;

/// The mutant that the environment variable PARDEL_MUTANT asks for; empty where it asks for none.
[[nodiscard]] inline std::string_view wanted_mutant() {
  static const std::string_view wanted = [] {
    const char* name = std::getenv("PARDEL_MUTANT");
    return name == nullptr ? std::string_view() : std::string_view(name);
  }();
  return wanted;
}

[[nodiscard]] inline bool mutated(std::string_view mutant) { return mutant == wanted_mutant(); }
/// Of a family of mutants, named by a common prefix and what it varies over.
[[nodiscard]] inline bool mutated(std::string_view prefix, std::string_view member) {
  const std::string_view wanted = wanted_mutant();
  return wanted.starts_with(prefix) && wanted.substr(prefix.size()) == member;
}

#else

inline constexpr bool mutants_are_compiled_in = false;
// Folded before anything else is optimised, which leaves all code as it would be without the seam: for that the
// parameters are plain pointers, and in hot code mutated() comes first in its condition.
[[nodiscard]] constexpr bool mutated(const char* /*mutant*/) { return false; }
[[nodiscard]] constexpr bool mutated(const char* /*prefix*/, const char* /*member*/) { return false; }

#endif

}  // namespace pardel
