// A problem of a Pslg: its kind, its place, and its message.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "../core/pslg.hpp"

namespace pardel {

enum class ProblemKind : std::uint8_t {
  non_finite_coordinate,
  coordinate_out_of_range,  ///< magnitude above 2^200, or below 2^-140 and not zero
  wrong_count,              ///< the number of attributes or markers does not fit the number of points
  index_out_of_range,       ///< an end of a segment is not the index of a point
  duplicate_points,
  zero_length_segment,
  duplicate_segments,
  crossing_segments,     ///< two segments cross at a point interior to both; `where` is this point, rounded
  overlapping_segments,  ///< two segments are collinear and have more than one common point
  point_on_segment,      ///< a point lies in the interior of a segment
  all_points_collinear,  ///< also reported for fewer than three points
  unclosed_outline,      ///< no segments enclose a face, so there is no domain
  no_domain,             ///< every face contains a hole
  hole_outside,          ///< the hole is in no bounded face, or exact arithmetic cannot use its coordinates
  hole_on_segment,
  region_outside,  ///< the seed is in no face of the domain, or exact arithmetic cannot use its coordinates
  region_on_segment,
  regions_share_face,  ///< two regions, consecutive among those of a face, have their seeds in the same face
  bad_region_cap,      ///< an area cap that is zero, negative or NaN
  cancelled,           ///< no problem of the Pslg: ValidateOptions::go_on ended the search; this is then the only entry
};
/// The enumerator as text: "duplicate_points".
[[nodiscard]] const char* name(ProblemKind kind);

/// How messages name points, segments, holes and regions.
struct NumbersInMessages {
  int base = 0;                             ///< the number of the first one: usually Pslg::first_id.value
  std::span<const std::uint64_t> points{};  ///< if not empty, the numbers of the points, instead of those from base on
  /// If not empty, the segments, which have no numbers: messages name their ends, "3-7".
  std::span<const Segment> unnumbered{};
};

struct Problem {
  ProblemKind kind;
  /// The points, segments, holes or regions concerned, counted from 0. The kind determines which of them:
  /// a point and a segment for point_on_segment, a hole and a segment for hole_on_segment, and so on.
  std::vector<Index> ids;
  Point where;

  /// One sentence with ids and coordinates. `base` is the id that the message gives to the first point, segment, hole
  /// or region: usually Pslg::first_id.value.
  [[nodiscard]] std::string message(int base = 0) const;
  [[nodiscard]] std::string message(const NumbersInMessages& numbers) const;
  /// The numbers in the message, in the order of `ids`: two for a segment that has none itself.
  [[nodiscard]] std::vector<std::uint64_t> numbers_of_ids(const NumbersInMessages& numbers) const;
};

/// The messages of several problems, one per line.
[[nodiscard]] std::string messages(const std::vector<Problem>& problems, int base = 0);
[[nodiscard]] std::string messages(const std::vector<Problem>& problems, const NumbersInMessages& numbers);

}  // namespace pardel
