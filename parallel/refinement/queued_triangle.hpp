// A triangle in a queue, and the rule that tells if an entry of a queue is out of date (stale).
#pragma once

#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// A triangle that waits to be processed. The entry stores the values from the time when it was queued.
///
/// An insertion that destroys a triangle leaves the entries of this triangle in the queues. The entries are then stale.
/// They are dropped when they are taken out of the queue.
///
/// The rule: an entry is stale if and only if the slot of its triangle has another first corner now. The rule relies on
/// a guarantee of retriangulate() (triangulation/cavity.hpp): every slot of a cavity gets a new triangle at once, whose
/// first corner is the new vertex. No triangle that was queued before has this vertex.
///
/// Flips (triangulation/flips.hpp) are the exception. They can replace the other two corners of a triangle and keep the
/// first corner. After a flip, an entry that is not stale may refer to a triangle that was never assessed. The task
/// therefore assesses the triangle again before it splits it (Insertion::has_flipped).
struct QueuedTriangle {
  /// The side for which the triangle was queued: the side to split, or the shortest side of a triangle to split.
  /// Only the task that queued the triangle relies on the side. Any other task assesses the triangle again.
  EdgeRef side;
  VertexId first_corner;

  /// The entry for the triangle of `side`, with its present first corner.
  [[nodiscard]] static QueuedTriangle now(const Triangulation& t, EdgeRef side) { return {side, t.slot(side).v[0]}; }
  [[nodiscard]] TriangleId id() const { return side.triangle(); }
  [[nodiscard]] bool is_current(const Triangulation& t) const { return t.slot(side).v[0] == first_corner; }
};

}  // namespace pardel::engine
