// Runs the harness in a temporary folder.
#pragma once

#include <string>
#include <vector>

#include "../cli/program.hpp"

namespace pardel::testing {

class HarnessWorkshop : public Workshop {
 protected:
  /// In a sanitized build, without the limit on memory: the sanitizer's shadow memory exceeds any such limit.
  Ran harness(std::vector<std::string> arguments, const RunOptions& options = {}) const {
    if (sanitized) arguments.insert(arguments.end(), {"--memory-limit", "0"});
    return run(PARDEL_HARNESS, arguments, options);
  }
};

}  // namespace pardel::testing
