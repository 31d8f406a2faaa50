// The structure of the repository as rules on its #include lines. Tables in rules.cpp define all rules.
#pragma once

#include <string>
#include <vector>

#include "source_tree.hpp"

namespace pardel::structure {

/// All places where the tree breaks a rule, one line each: "FILE:LINE: what is wrong".
[[nodiscard]] std::vector<std::string> violations(const SourceTree& tree);

/// The exceptions of the tables that no file of the tree uses, one line each.
[[nodiscard]] std::vector<std::string> unused_exceptions(const SourceTree& tree);

/// The includes between folders, counted: "parallel/refinement -> parallel/triangulation 9", one line each, sorted.
[[nodiscard]] std::vector<std::string> drawing(const SourceTree& tree);

}  // namespace pardel::structure
