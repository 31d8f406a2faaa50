// The segments that --keep names.
#pragma once

#include <span>

#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "input.hpp"

namespace pardel::cli {

/// Errors (`invalid_input`): no segment of the domain has one of these markers, where 1 also stands for unmarked
/// segments; or repair has moved an end of a segment with one of them.
[[nodiscard]] Status check_kept_segments(const MaybeRepaired& repaired, std::span<const int> markers);
/// The same of a mesh to refine. Edges of its boundary that are no segments have the marker 1.
[[nodiscard]] Status check_kept_segments(const CoarseMesh& coarse, std::span<const int> markers);

/// For a domain that is read in parts: true if one of the segments has the marker; and the error if no part has one.
[[nodiscard]] bool has_segment_with(std::span<const Segment> segments, int marker);
[[nodiscard]] Error no_kept_segment(int marker);

}  // namespace pardel::cli
