// Gaps: places of a domain that are much narrower than their surroundings.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "validate.hpp"

namespace pardel {

enum class GapKind : std::uint8_t {
  close_points,        ///< two points that no segment joins
  short_segment,       ///< a segment, and its two ends
  point_near_segment,  ///< a point, and a segment that does not end there
  point_near_hull,     ///< a point, and a side of the convex hull, which is given by its two ends
};
/// The enumerator as text: "close_points".
[[nodiscard]] const char* name(GapKind kind);

/// A narrow place inside the domain. Around it the mesh needs many small triangles, or triangles that double precision
/// cannot represent. Narrow places are mostly the result of rounding, but can be wanted.
struct Gap {
  GapKind kind;
  std::vector<Index> points;  ///< counted from 0, as the kind lists them
  Index segment = no_index;   ///< for short_segment and point_near_segment
  double distance = 0;        ///< between the two points, or from the point to the segment or side
  /// The length of the surroundings: the length of the segment, or the longest segment at the point, whichever is
  /// shorter. At a point without segments beside another point, the median distance to the points around it; of two
  /// points the one where the surroundings are shorter.
  double surroundings = 0;
  Point where;  ///< the first point

  /// One sentence. `base` is the id that the message gives to the first point or segment: usually Pslg::first_id.value.
  [[nodiscard]] std::string message(int base = 0) const;
};

/// A gap that is so many times narrower than its surroundings can be a mistake.
inline constexpr double much_narrower = 1000;

/// The gaps of a domain, narrowest first. A gap is narrower than a millionth of the extent of the domain, and a
/// thousandth of its surroundings, unless these are a side of the convex hull; or it is narrower than 2^-32 of the
/// larger coordinate there, which is a thousand times the shortest edge that the mesher makes there. Of the domain only
/// the segments count whose largest coordinates are about as large as those at the gap; without segments, such points.
/// So nothing far away matters. Gaps outside the domain are not found, for example between the outlines of two parts of
/// the domain that nearly touch. Each point is the first point of one gap at most. Errors and time: those of
/// triangulate(). `threads`: 0 or less for as many as OpenMP offers.
[[nodiscard]] Result<std::vector<Gap>> find_gaps(const ValidPslg& domain, int threads = 0);

/// A snapping distance (RepairOptions::snap) that closes the narrowest gaps and leaves those open that are much wider:
/// twice the distance of a gap, such that the next gap is at least 16 times as wide. Zero without gaps. Precondition:
/// the narrowest gap is the first.
[[nodiscard]] double closing_snap(std::span<const Gap> gaps);

}  // namespace pardel
