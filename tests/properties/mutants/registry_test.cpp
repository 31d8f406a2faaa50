// The registry of mutants as a whole. It reads the registry only, and runs no mutant.
#include "../../../properties/mutants/registry.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace pardel::mutants {
namespace {

/// The killers of the mutants of one test program, and how many mutants each of them kills.
using Killed = std::map<std::string, std::size_t>;

std::map<std::string, Killed> killed_by_program() {
  std::map<std::string, Killed> killed;
  for (const Mutant& mutant : read_registry(PARDEL_REGISTRY)) ++killed[mutant.killer.program][mutant.killer.property];
  return killed;
}

/// A property that kills most mutants shows little about the other properties of its program: they could test nothing.
TEST(Registry, has_no_killer_with_more_than_a_third_of_the_mutants_of_its_program) {
  constexpr std::size_t enough = 9;  // a third of fewer mutants says little
  std::size_t programs = 0;
  for (const auto& [program, killers] : killed_by_program()) {
    std::size_t mutants = 0;
    for (const auto& [property, count] : killers) mutants += count;
    if (mutants < enough) continue;
    ++programs;
    for (const auto& [property, count] : killers)
      EXPECT_LE(3 * count, mutants) << property << " kills " << count << " of the " << mutants << " mutants of "
                                    << program << ". Name another property that fails for some of them.";
  }
  EXPECT_GE(programs, 5U);
}

}  // namespace
}  // namespace pardel::mutants
