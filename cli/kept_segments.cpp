#include "kept_segments.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "../core/support/shortest.hpp"

namespace pardel::cli {
namespace {

/// On the boundary, unmarked edges have the marker 1.
bool has(const Segment& segment, int marker) {
  return segment.marker == marker || (segment.marker == 0 && marker == 1);
}

}  // namespace

Status check_kept_segments(const MaybeRepaired& repaired, std::span<const int> markers) {
  const Pslg& domain = repaired.domain.pslg();
  const Pslg& read = repaired.original ? *repaired.original : domain;
  for (const int marker : markers) {
    const bool is_of_hull = marker == 1 && repaired.domain.convex_hull();
    const auto is_kept = [&](const Segment& s) { return has(s, marker); };
    if (!is_of_hull && std::ranges::none_of(read.segments, is_kept))
      return Error{ErrorKind::invalid_input, fmt::format("--keep: no segment of the domain has the marker {}", marker)};
    if (!repaired.original) continue;
    for (const Segment& s : read.segments)
      for (const Index end : {s.a, s.b})
        if (is_kept(s) && !(domain.points[repaired.point_map[end]] == read.points[end]))
          return Error{ErrorKind::invalid_input,
                       fmt::format("--repair would move point {} at {}, an end of a segment that --keep {} keeps; a "
                                   "smaller --snap may leave it in place",
                                   end + static_cast<Index>(read.first_id.value), shortest(read.points[end]), marker)};
  }
  return Done{};
}

}  // namespace pardel::cli
