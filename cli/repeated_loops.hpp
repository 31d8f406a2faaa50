// Loops of segments that a domain contains more than once.
#pragma once

#include <span>
#include <string>

#include "../core/pslg.hpp"
#include "../parallel/validate.hpp"

namespace pardel::cli {

/// One sentence per closed loop whose segments are all given twice or more, each after a line break, for example
/// "\nThe loop of points 1 to 4 is given twice.". `problems`: those of the Pslg. O(n + p log p) for p problems.
[[nodiscard]] std::string repeated_loops(const Pslg& pslg, std::span<const Problem> problems);

}  // namespace pardel::cli
