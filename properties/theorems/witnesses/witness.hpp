// The stored witnesses: scenes which show that a theorem needs a hypothesis, that a bound is tight, or that a
// similar statement is false. The witness NAME has the files NAME.poly and NAME.svg (its picture) in tests/witnesses.
//
// To add a witness: write its .poly file (the point with marker k is the k-th insertion; see framework/scene.hpp), add
// a row to the table of its theorem (witnesses_THEOREM.cpp; a new table also goes into all_witnesses()), and run
// `pardel_witnesses tests/witnesses` to draw the picture. witnesses_test checks the claim of every witness. It fails
// for files without a row, and for pictures that differ from what the program draws.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "../framework/scene.hpp"

namespace pardel::properties {

struct Witness {
  std::string name;   ///< the name of the file, without .poly
  std::string claim;  ///< what the scene shows, in one sentence
  testing::AssertionResult (*holds)(const Scene& scene);
  Scene (*make)() = nullptr;  ///< makes the scene again by a search or a formula; null for scenes made by hand
};

/// GoogleTest uses this to print a witness.
inline void PrintTo(const Witness& witness, std::ostream* out) { *out << witness.name; }

[[nodiscard]] std::vector<Witness> independence_witnesses();
[[nodiscard]] std::vector<Witness> radius_witnesses();
[[nodiscard]] std::vector<Witness> region_witnesses();
[[nodiscard]] std::vector<Witness> refinement_witnesses();

[[nodiscard]] std::vector<Witness> all_witnesses();

}  // namespace pardel::properties
