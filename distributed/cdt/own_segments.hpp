// Each rank gets the segments that end at its points.
#pragma once

#include <cstdint>
#include <vector>

#include "../../core/part_of_points.hpp"
#include "../../core/ranks.hpp"
#include "../delaunay/triangulated_points.hpp"
#include "given_segment.hpp"

namespace pardel::engine {

struct OwnSegments {
  std::vector<GivenSegment> segments;  ///< those that end at own points, in the order of their ends
  /// False, on all ranks, if a segment of any rank names a point that does not exist, has equal ends, or has the same
  /// ends as another one. The list may then lack segments.
  bool are_sound = true;
};

/// Collective. `read`: the segments that this rank has read.
[[nodiscard]] OwnSegments send_to_owners_of_ends(const PartOfSegments& read, const TriangulatedPoints& points,
                                                 Ranks& ranks);

}  // namespace pardel::engine
