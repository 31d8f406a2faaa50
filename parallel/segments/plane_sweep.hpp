// A sweep of the plane from left to right. It finds all conflicts between segments and points, and the segment directly
// below each point.
#pragma once

#include <compare>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "../../core/pslg.hpp"
#include "../../core/support/stop_signal.hpp"
#include "conflicts.hpp"
#include "reach.hpp"

namespace pardel::engine {

/// Preconditions: the ends of segments and the candidates are distinct points in the range of the predicates; no two
/// segments have the same ends, and no segment has equal ends.
struct SweepInput {
  std::span<const Point> points;
  std::span<const Segment> segments;
  /// The points to examine that are not an end of a segment.
  std::span<const Index> candidates{};
  /// Places to locate among the segments. They can lie anywhere, also on a point. A place with coordinates that the
  /// predicates cannot use is ignored.
  std::span<const Point> queries{};
  /// The sweep ends as soon as it has found this number of conflicts of one kind.
  std::size_t most = std::numeric_limits<std::size_t>::max();
  /// A point is near a segment if it is closer than this, and sees the segment at an angle of more than 120 degrees.
  /// Null: none. So the point is not near in this sense if it is close to an end only. A point that is as far as the
  /// reach from both ends, and not near, is at least half as far from the segment. Queries count as points without
  /// segments.
  const Reach* reach = nullptr;
  StopSignal* stop = nullptr;  ///< ends the sweep with an exception
};

/// A point, or a query (its index plus the number of points), and a segment. The point is not on the segment.
struct NearPoint {
  Index point;
  Index segment;
  friend auto operator<=>(const NearPoint&, const NearPoint&) = default;  // NOLINT(modernize-use-nullptr)
};

struct Swept {
  /// All conflicts, without duplicates, in ascending order. Exact.
  std::vector<Conflict> conflicts;
  /// For each point, then for each query: the first segment that a ray straight down meets, and no_index if there is
  /// none. The ray is turned by an infinitesimal amount towards the right, so that it passes to the right of points on
  /// the vertical below. Only for ends of segments, candidates and usable queries, and only if the sweep did not end
  /// early.
  std::vector<Index> below;
  /// For each query: a segment that contains it, possibly as an end; no_index if there is none.
  std::vector<Index> through;
  /// The points and queries near a segment. Pairs in which the segment is steeper than the diagonals can be missing:
  /// see find_near_points().
  std::vector<NearPoint> near;
  /// The number of times that the sweep determined the side of a segment on which a point lies: a measure of its work.
  std::size_t orientations = 0;
};

/// O((n + k) log n) for n points, segments and queries, and k conflicts; the number of near-parallel, long or nested
/// segments does not matter, nor does the number of segments at a point. Exact: the order of the segments along the
/// sweep line is compared at given points only, never at computed ones. Source: Boissonnat and Preparata, "Robust plane
/// sweep for intersecting segments", 2000.
[[nodiscard]] Swept sweep_plane(const SweepInput& input);

/// All pairs of a point or a query and a segment that it is near, sorted. `swept` is the sweep of the same input; for
/// steep segments, this function makes another one with exchanged coordinates.
[[nodiscard]] std::vector<NearPoint> find_near_points(const SweepInput& input, const Swept& swept);

}  // namespace pardel::engine
