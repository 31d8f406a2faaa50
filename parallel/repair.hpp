// Repair: turns a Pslg with duplicate points, crossing or overlapping segments, or misplaced seeds into a valid domain.
#pragma once

#include <string>
#include <vector>

#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "validate.hpp"

namespace pardel {

struct Repaired {
  ValidPslg domain;
  std::vector<Index> point_map;    ///< old point -> new point
  std::vector<Index> segment_map;  ///< new segment -> the old segment that contains it, the first if several do
  /// The changes, one sentence each. Ids are those of the old Pslg, counted from its first_id.
  std::vector<std::string> log;
};

/// Merges equal points, and points closer than `snap` (a length, finite, >= 0). Drops zero-length and duplicate
/// segments. Splits segments where they cross, overlap or contain a point. Drops holes and regions that lie outside or
/// on a segment. Points added at crossings are rounded; their attributes are interpolated and their markers are those
/// of the segment. Segments move only by the rounding of these points. The segments bound the domain; the convex hull
/// is not used.
///
/// Errors: `usage` for a bad `snap`. `invalid_input` if a coordinate, an index, a count or an area cap is unusable, if
/// no segments enclose a domain, or if rounding the crossings causes new crossings again and again. The message has
/// one line per problem.
///
/// Time: a few searches for conflicts, each O((n + p) log n) on typical input for n points and segments and p
/// conflicts. Source: after Hobby, "Practical segment intersection with finite precision output", 1999.
[[nodiscard]] Result<Repaired> repair(const Pslg& pslg, double snap = 0);

}  // namespace pardel
