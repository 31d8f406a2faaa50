#include "kept_segments.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "../core/support/shortest.hpp"
#include "around_mesh.hpp"
#include "faces.hpp"

namespace pardel::cli {
namespace {

/// On the boundary, unmarked edges have the marker 1.
bool has(const Segment& segment, int marker) {
  return segment.marker == marker || (segment.marker == 0 && marker == 1);
}

bool has_boundary_without_segment(const CoarseMesh& coarse) {
  EdgeSet segments{coarse.domain.pslg.segments};
  segments.finish();
  return std::ranges::any_of(boundary(coarse.mesh), [&](const Segment& s) { return !segments.contains(s.a, s.b); });
}

}  // namespace

bool has_segment_with(std::span<const Segment> segments, int marker) {
  return std::ranges::any_of(segments, [&](const Segment& s) { return has(s, marker); });
}

Error no_kept_segment(int marker) {
  return {ErrorKind::invalid_input, fmt::format("--keep: no segment of the domain has the marker {}", marker)};
}

Status check_kept_segments(const MaybeRepaired& repaired, std::span<const int> markers) {
  const Pslg& domain = repaired.domain.pslg();
  const Pslg& read = repaired.original ? *repaired.original : domain;
  for (const int marker : markers) {
    const bool is_of_hull = marker == 1 && repaired.domain.convex_hull();
    if (!is_of_hull && !has_segment_with(read.segments, marker)) return no_kept_segment(marker);
    if (!repaired.original) continue;
    for (const Segment& s : read.segments)
      for (const Index end : {s.a, s.b})
        if (has(s, marker) && !(domain.points[repaired.point_map[end]] == read.points[end]))
          return Error{ErrorKind::invalid_input,
                       fmt::format("--repair would move point {} at {}, an end of a segment that --keep {} keeps; a "
                                   "smaller --snap may leave it in place",
                                   end + static_cast<Index>(read.first_id.value), shortest(read.points[end]), marker)};
  }
  return Done{};
}

Status check_kept_segments(const CoarseMesh& coarse, std::span<const int> markers) {
  for (const int marker : markers)
    if (!has_segment_with(coarse.domain.pslg.segments, marker) &&
        !(marker == 1 && has_boundary_without_segment(coarse)))
      return no_kept_segment(marker);
  return Done{};
}

}  // namespace pardel::cli
