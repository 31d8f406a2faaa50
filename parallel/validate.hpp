// Is a Pslg one that can be meshed? validate() finds every problem.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "../core/goal.hpp"
#include "../core/pslg.hpp"

namespace pardel {

enum class ProblemKind : std::uint8_t {
  non_finite_coordinate,
  coordinate_out_of_range,  ///< |x| above largest_coordinate, or tiny but not zero (predicates.hpp)
  wrong_count,              ///< attribute or marker arrays whose length does not fit the points
  index_out_of_range,       ///< a segment names a point that does not exist
  duplicate_points,
  zero_length_segment,
  duplicate_segments,
  crossing_segments,     ///< at an interior point of both; `where` is the crossing, rounded
  overlapping_segments,  ///< collinear, with more than a point in common
  point_on_segment,      ///< a point in the interior of a segment
  all_points_collinear,  ///< or fewer than three points
  unclosed_outline,      ///< the exterior reaches everything: no domain would be left
  no_domain,             ///< an outline exists, but holes eat all of it
  hole_outside,          ///< in no bounded face, or at a coordinate that is unusable
  hole_on_segment,
  region_outside,  ///< not in the domain (a hole's face is not), or at a coordinate that is unusable
  region_on_segment,
  regions_share_face,  ///< two region seeds in one face
  bad_region_cap,      ///< an area cap that is not positive: zero, negative or NaN
};
[[nodiscard]] const char* name(ProblemKind kind);

/// ids: the points, segments, holes or regions concerned (which, follows from the kind), zero-based.
struct Problem {
  ProblemKind kind;
  std::vector<Index> ids;
  Point where;
  /// One sentence with ids and coordinates.
  [[nodiscard]] std::string message(int base = 0) const;
};

struct ValidateOptions {
  bool convex_hull = false;  ///< the outline is the hull: an unclosed outline is no problem
  /// Per kind; crossings can be quadratic in number. The search for conflicts of segments (crossing, overlapping,
  /// point on segment) ends when it has found so many of one of these.
  std::size_t max_problems = 10'000;
  int threads = 1;  ///< up to so many; what is found does not depend on it
};

/// Every problem, in order of kind, then ids. Empty: the Pslg can be meshed. Questions about faces (unclosed
/// outline, no domain, holes, regions) are asked only where segments meet as they should and coordinates are
/// usable. O((n + problems) log n) on typical input. Exact: no tolerance anywhere.
[[nodiscard]] std::vector<Problem> validate(const Pslg& pslg, const ValidateOptions& options = {});

}  // namespace pardel
