// Segments of the input that are divided among ranks.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "../../core/pslg.hpp"
#include "../delaunay/local_delaunay.hpp"
#include "../delaunay/own_points.hpp"

namespace pardel::engine {

/// A segment of the input. End `a` comes before end `b` along the curve, whatever its direction in the input.
struct GivenSegment {
  Site a, b;
  Index number;  ///< in the input; no_index for an edge of the convex hull
  int marker;
};

/// The positions of the ends. They tell segments apart.
using PositionsOfEnds = std::pair<std::uint64_t, std::uint64_t>;
[[nodiscard]] inline PositionsOfEnds ends_of(const GivenSegment& s) { return {s.a.position, s.b.position}; }

inline void sort_by_ends(std::vector<GivenSegment>& segments) { std::ranges::sort(segments, {}, ends_of); }

/// The segment with these ends, or nullptr. Precondition: the segments are sorted by their ends.
[[nodiscard]] inline const GivenSegment* with_ends(const std::vector<GivenSegment>& sorted, PositionsOfEnds ends) {
  const auto at = std::ranges::lower_bound(sorted, ends, {}, ends_of);
  return at != sorted.end() && ends_of(*at) == ends ? &*at : nullptr;
}

}  // namespace pardel::engine
