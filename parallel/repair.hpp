// Repair: turns a Pslg with duplicate points, crossing or overlapping segments, tiny gaps, or misplaced seeds into a
// valid domain.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "validate.hpp"

namespace pardel {

struct RepairOptions {
  /// Gaps smaller than this length are closed. Finite, >= 0. Zero: only equal points are merged, and no point or
  /// segment moves by more than the rounding of crossings.
  ///
  /// Without a value each gap has a distance of its own: 2^-38 (3.6e-12) of its scale, which is the largest magnitude
  /// of a coordinate of the segments at the gap, on the side where it is smaller. So a huge part of a domain changes
  /// nothing at a small part beside it. Coordinates of a magnitude are about 2^-53 of it apart, and there the mesher
  /// makes no edge shorter than 2^-42 of it (Options::min_edge). A gap of 2^-38 is 16 such edges wide. Smaller gaps are
  /// mostly the rounding of some program, and no mesh could be graded into them.
  ///
  /// If that repair fails, for example because the whole domain is narrower, the distances are a 16th, a 256th, a
  /// 4096th, and finally zero. If splitting at rounded crossings makes ever more crossings, zero is tried at once. If
  /// the repaired domain then has tiny gaps (gaps.hpp) between longer segments, the repair is made again with the
  /// distance that closes the narrowest of them (closing_snap), until there are none. This distance counts at scales
  /// with the same power of two only. A gap is tiny up to 2^-30 (9.3e-10) of its scale, or a millionth of the extent
  /// of the segments of about the same scale, if that is smaller. Crossings of nearly parallel segments, and copies of
  /// an outline in two projections, leave such gaps. A distance that fails for the Pslg may succeed for its repair, so
  /// after a failure the result is repaired further, until nothing changes.
  std::optional<double> snap{};
  /// The domain is the convex hull of the points. An unclosed outline is then no problem.
  bool convex_hull = false;
  /// Called in the calling thread from time to time, about every 4 ms. Return false to end the repair with
  /// ErrorKind::cancelled.
  std::function<bool()> go_on{};
};

/// The largest default distance of all gaps: 2^-38 (3.6e-12) times the largest magnitude of a coordinate of a segment's
/// end; without segments, of a point.
[[nodiscard]] double default_snap(const Pslg& pslg);

/// The largest width of a tiny gap.
[[nodiscard]] double largest_default_snap(const Pslg& pslg);

/// Points or segments that snapping moved.
struct Moved {
  std::size_t count = 0;
  Index farthest = no_index;  ///< the one that moved farthest
  double distance = 0;        ///< how far it moved
};

struct Repaired {
  ValidPslg domain;
  std::vector<Index> point_map;  ///< old point -> new point
  /// New segment -> the old segment that contains it, the first if several do; no_index for a side of the convex hull.
  std::vector<Index> segment_map;
  /// The changes, one sentence each. Ids are those of the old Pslg, counted from its first_id. Empty if nothing
  /// changed.
  std::vector<std::string> log;
  double snap = 0;        ///< the snapping distance that was used; without a given one, the largest of all
  Moved moved_points;     ///< old points that were merged into another place
  Moved bent_segments{};  ///< old segments that were bent to points beside them; rounding does not count
};

/// Merges equal points, and points closer than the snapping distance. Drops zero-length and duplicate segments. Splits
/// segments where they cross, overlap or contain a point. Bends segments to points that are closer than the snapping
/// distance: a segment touches a point before it could pass over the point, except within about twice the snapping
/// distance of its ends. Afterwards, no two points are closer than the snapping distance, and no point is closer than
/// half of it to a segment that does not end there. Drops holes and regions that lie outside or on a segment, and, if
/// something was snapped, those closer than the snapping distance to a segment, because their face may have vanished,
/// and those in faces that became one point.
/// Of several regions in one face the last one stays, as in Triangle. Points added at crossings are rounded; their
/// attributes are interpolated and their markers are those of the segment. Repairing a repaired domain changes nothing.
///
/// If the domain is the convex hull of its points, and points lie near a side of the hull, all sides become segments,
/// which are bent to these points. The domain then ends at these segments: ValidPslg::convex_hull() is false, and
/// Goal::convex_hull should be false, too.
///
/// Errors: `usage` for a bad snapping distance. `cancelled` if options.go_on returns false. `invalid_input` if a
/// coordinate, an index, a count or an area cap is unusable, if no segments enclose a domain, or if rounding the
/// crossings causes new crossings again and again. The message has one line per problem.
///
/// Time: a few searches for conflicts, each O((n + p) log n) for n points and segments and p conflicts. Sources: after
/// Hobby, "Practical segment intersection with finite precision output", 1999; Halperin and Packer, "Iterated snap
/// rounding", 2002.
[[nodiscard]] Result<Repaired> repair(const Pslg& pslg, const RepairOptions& options = {});

/// What repair() with a snapping distance makes of a domain.
struct SnapEffect {
  bool succeeds = false;         ///< false: the repair fails, and the numbers below are 0
  std::size_t points = 0;        ///< points that are merged with others
  std::size_t segments = 0;      ///< segments that are merged with others or vanish
  std::size_t faces_before = 0;  ///< faces of the domain: what can be reached without crossing a segment
  std::size_t faces_after = 0;
  double area = 0;  ///< the change of the area of the domain, divided by its area
  /// True if nothing is removed but narrow gaps: the repair keeps all holes and regions, each connected part of the
  /// domain is wider than the distance, and the area changes by at most one hundredth. The width of a part is twice its
  /// area divided by its perimeter.
  bool keeps_all_parts = false;
};
/// Errors and time: those of triangulate() and repair(); a repair that fails because nothing of the domain is left is
/// no error.
[[nodiscard]] Result<SnapEffect> effect_of_snap(const ValidPslg& domain, double snap);

}  // namespace pardel
