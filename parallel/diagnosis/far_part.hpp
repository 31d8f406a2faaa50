// A point or a segment that lies far away from everything else.
#pragma once

#include <optional>

#include "../warnings.hpp"

namespace pardel::engine {

/// The warning of kind far_part, if there is such a part. O(n).
[[nodiscard]] std::optional<Warning> find_far_part(const Pslg& pslg);

}  // namespace pardel::engine
