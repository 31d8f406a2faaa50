// Resolves conflicts: makes a planar graph of segments that cross, overlap or nearly touch.
#pragma once

#include <numeric>
#include <vector>

#include "../../core/pslg.hpp"
#include "../../core/support/stop_signal.hpp"
#include "../segments/snapping.hpp"

namespace pardel::engine {

/// The Pslg in its present state, with the origin of its points and segments.
struct Work {
  Pslg pslg;
  std::vector<Index> point_map;  ///< old point -> point
  std::vector<Index> source;     ///< segment -> old segment
};

/// 0, 1, ..., n - 1: a map of Work before anything has changed.
[[nodiscard]] inline std::vector<Index> identity_map(std::size_t n) {
  std::vector<Index> all(n);
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

/// Changes the points and segments until segments meet only at common ends and contain no other point. Unless
/// `snapping` is zero, no two points are then closer than it allows at their scales (Reach), and no point is closer
/// than half of that to a segment that does not end there. Returns false if this fails. Asks `stop`.
[[nodiscard]] bool untangle(Work& work, const Snapping& snapping, StopSignal& stop);

/// Rounding puts points on a straight boundary a little inside of the convex hull. No flat triangle between such a
/// point and the side of the hull helps anybody. So the sides become segments, which are bent to the points near them,
/// and the domain ends at these segments. Their source is no_index. Changes nothing and returns false if no point is
/// near a side, if all points lie on a line, if the hull is so narrow that its sides fall into one, or if the segments
/// cannot be untangled. Precondition: `work` is untangled with the same snapping distances.
[[nodiscard]] bool draw_hull_if_points_are_near(Work& work, const Snapping& snapping, StopSignal& stop);

}  // namespace pardel::engine
