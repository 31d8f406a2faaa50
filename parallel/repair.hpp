// Repair: makes a valid domain of a Pslg with duplicate points, crossing or overlapping segments, or misplaced seeds.
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
  std::vector<Index> segment_map;  ///< new segment -> the old segment that contains it, the first where several do
  /// The changes, one sentence each. Ids are those of the old Pslg, counted from its first_id.
  std::vector<std::string> log;
};

/// Merges equal points, and points closer than `snap` (a length, finite, >= 0). Drops zero-length and duplicate
/// segments. Splits segments where they cross, overlap or contain a point. Drops holes and regions that lie outside or
/// on a segment. Points added at crossings are rounded; their attributes are interpolated and their markers are those
/// of the segment. Segments stay within a rounding of their old places. The outline is that of the segments, not the
/// convex hull.
///
/// Errors: `usage` for a bad `snap`. `invalid_input` where a coordinate, an index, a count or an area cap is unusable,
/// where nothing encloses a domain, or where rounded crossings bring about new ones without end. The message has one
/// line per problem.
///
/// Time: a few searches for conflicts, O((n + p) log n) each on typical input, with n points and segments and p
/// conflicts. Source: after Hobby, "Practical segment intersection with finite precision output", 1999.
[[nodiscard]] Result<Repaired> repair(const Pslg& pslg, double snap = 0);

}  // namespace pardel
