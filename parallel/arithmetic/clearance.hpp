// Segments that come so close to others that rounding could move their split points across them.
#pragma once

#include <span>

#include "../../core/pslg.hpp"

namespace pardel::engine {

/// Another segment, or the end of one, beside a segment. Its distance from the segment is at least `gap` at the place
/// `at`, and grows by at least `slope` per length along the segment.
struct Clearance {
  Point at;
  double gap = 0;
  double slope = 0;
  /// True if `at` is a point that the segment passes: all subsegments have to leave it on the same side.
  bool is_passed = false;
};

/// The ends of a segment or of a part of it.
struct EndPoints {
  Point a, b;
};

/// True if the segment stays clear of what is beside it when its subsegment `edge` is split at p, which rounding has
/// moved off the line of the segment (THEORY.md, Refinement: hairlines, Lemma 9). Two segments that both stay clear of
/// each other do not cross, wherever they are split. O(number of clearances).
[[nodiscard]] bool keeps_clear(std::span<const Clearance> all, EndPoints segment, EndPoints edge, Point p);

}  // namespace pardel::engine
