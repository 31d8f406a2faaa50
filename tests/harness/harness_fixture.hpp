// Runs the harness in a temporary folder.
#pragma once

#include <string>
#include <vector>

#include "../cli/program.hpp"

namespace pardel::testing {

class HarnessFixture : public Workshop {
 protected:
  /// In a sanitized build the limit on memory is removed, because the sanitizer's shadow memory exceeds every such
  /// limit.
  Ran harness(std::vector<std::string> arguments, const RunOptions& options = {}) const {
    if (sanitized) arguments.insert(arguments.end(), {"--memory-limit", "0"});
    return run(PARDEL_HARNESS, arguments, options);
  }
};

}  // namespace pardel::testing
