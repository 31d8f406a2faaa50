// The schemes under their names, for tests and tables that treat all of them alike.
#pragma once

#include <string_view>
#include <vector>

#include "workers/problem.hpp"

namespace pardel::schemes {

struct Scheme {
  std::string_view name;   ///< for the command line: "closures"
  std::string_view title;  ///< for tables
  /// The outcomes for these numbers of workers, in their order. Where they make one mesh, its scheme runs once, and
  /// only the first outcome has a mesh.
  Result<std::vector<Outcome>> (*run)(const Problem& problem, const std::vector<int>& workers);
  bool refines = true;  ///< false: it triangulates given points, and meets no goal
};

/// In the order of the tables. The first is the refinement by one worker.
[[nodiscard]] const std::vector<Scheme>& all_schemes();

}  // namespace pardel::schemes
