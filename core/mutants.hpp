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

/// Is this the mutant that the environment variable PARDEL_MUTANT asks for?
[[nodiscard]] inline bool mutated(std::string_view mutant) {
  static const std::string_view wanted = [] {
    const char* name = std::getenv("PARDEL_MUTANT");
    return name == nullptr ? std::string_view() : std::string_view(name);
  }();
  return mutant == wanted;
}

#else

inline constexpr bool mutants_are_compiled_in = false;
[[nodiscard]] constexpr bool mutated(std::string_view /*mutant*/) { return false; }

#endif

}  // namespace pardel
