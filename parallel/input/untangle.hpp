// Resolves conflicts: makes a planar graph of segments that cross, overlap or nearly touch.
#pragma once

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

/// Changes the points and segments until segments meet only at common ends and contain no other point. Unless
/// `snapping` is zero, no two points are then closer than it allows at their scales (Reach), and no point is closer
/// than half of that to a segment that does not end there. Returns false if this fails. Asks `stop`.
[[nodiscard]] bool untangle(Work& work, const Snapping& snapping, StopSignal& stop);

}  // namespace pardel::engine
