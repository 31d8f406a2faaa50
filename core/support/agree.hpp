// Ranks tell each other whether a step has succeeded, and agree on one error if it has not.
#pragma once

#include "../ranks.hpp"
#include "../result.hpp"

namespace pardel {

/// Collective. Done if all ranks pass Done. Otherwise the error of the first rank that failed; its message names the
/// rank, unless all ranks failed.
[[nodiscard]] Status agree(const Status& here, Ranks& ranks);

/// The same, with the message as it is: for faults of the input, which do not depend on the rank that finds them.
[[nodiscard]] Status agree_on_input(const Status& here, Ranks& ranks);

}  // namespace pardel
