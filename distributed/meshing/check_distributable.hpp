// What only one process can do.
#pragma once

#include <string>

#include "../../core/result.hpp"
#include "../../parallel/options.hpp"

namespace pardel::engine {

/// A `usage` error for options that need the whole mesh.
[[nodiscard]] inline Status check_distributable(const Options& options) {
  const auto refuse = [](const char* what) {
    return Error{ErrorKind::usage, std::string(what) + " works in one process only, not in several ranks"};
  };
  if (options.max_vertices > 0) return refuse("a limit on the number of vertices");
  if (options.after_sweep) return refuse("a function that is called after each sweep");
  return Done{};
}

}  // namespace pardel::engine
