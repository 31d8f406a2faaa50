// The stored witnesses: scenes that show that a theorem's hypothesis is needed, that its bound is tight, or that a
// statement near it is false. Each is tests/witnesses/NAME.poly, with its picture beside it.
//
// To add one: put its .poly there (the point marked k is the k-th insertion; properties/theorems/framework/scene.hpp),
// add a row to the table of its theorem (witnesses_THEOREM.cpp; a new table goes into all_witnesses), and run
// `pardel_witnesses tests/witnesses` for the picture. witnesses_test then holds the file to its claim; it fails for
// files that no row claims and for pictures that are not what would be drawn.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "../framework/scene.hpp"

namespace pardel::properties {

struct Witness {
  std::string name;   ///< of its file, without .poly
  std::string claim;  ///< a sentence
  testing::AssertionResult (*holds)(const Scene& scene);
  Scene (*make)() = nullptr;  ///< where a search or a formula made the scene: again; otherwise it was made by hand
};

/// As GoogleTest prints it.
inline void PrintTo(const Witness& witness, std::ostream* out) { *out << witness.name; }

[[nodiscard]] std::vector<Witness> independence_witnesses();
[[nodiscard]] std::vector<Witness> radius_witnesses();
[[nodiscard]] std::vector<Witness> refinement_witnesses();

[[nodiscard]] std::vector<Witness> all_witnesses();

}  // namespace pardel::properties
