// The warning before the refinement that the mesh will have very many triangles.
#pragma once

#include <optional>
#include <string>

#include "../parallel/options.hpp"

namespace pardel::cli {

/// What the warning says besides the number.
struct WarnOfMany {
  std::string input;    ///< the name of the input file
  std::string program;  ///< that warns
  std::string advice;   ///< how to limit the size of the mesh
};

/// Sets options.before_refinement: it warns if the mesh is expected to have more than 50 million triangles, and then
/// sets `large`, which has to outlive the run. Does nothing if options.max_vertices keeps the mesh smaller.
void warn_of_many_triangles(WarnOfMany how, std::optional<LeastSize>& large, Options& options);

}  // namespace pardel::cli
