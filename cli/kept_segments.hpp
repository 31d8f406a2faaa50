// The segments that --keep names.
#pragma once

#include <span>

#include "../core/result.hpp"
#include "input.hpp"

namespace pardel::cli {

/// Errors (`invalid_input`): no segment of the domain has one of these markers, where 1 also stands for unmarked
/// segments; or repair has moved an end of a segment with one of them.
[[nodiscard]] Status check_kept_segments(const MaybeRepaired& repaired, std::span<const int> markers);

}  // namespace pardel::cli
