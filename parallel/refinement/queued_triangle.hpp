// A triangle in a queue, and the rule by which an entry of a queue is recognised as stale.
#pragma once

#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// A triangle that waits to be processed, as it was when it was queued.
///
/// An insertion that destroys a triangle leaves its entries in the queues. They are stale from then on, and are dropped
/// when they are taken out.
///
/// The rule: an entry is stale if and only if the slot of its triangle has another first corner now. The rule rests on
/// a guarantee of retriangulate() (triangulation/cavity.hpp): every slot of a cavity gets a new triangle at once, whose
/// first corner is the new vertex. No triangle that was queued before has that vertex.
///
/// Flips (triangulation/flips.hpp) are the exception. They can replace the other two corners of a triangle and keep
/// its first. After a flip, an entry that is current may name a triangle that was never assessed, so the task assesses
/// it again before it acts (Insertion::has_flipped).
struct QueuedTriangle {
  /// The side for which the triangle was queued: the side to split, or the shortest side of a triangle to split.
  /// Only the task that queued the triangle relies on the side. Everybody else assesses the triangle again.
  EdgeRef side;
  VertexId first_corner;

  /// The triangle of `side` as it is now.
  [[nodiscard]] static QueuedTriangle now(const Triangulation& t, EdgeRef side) { return {side, t.slot(side).v[0]}; }
  [[nodiscard]] TriangleId id() const { return side.triangle(); }
  [[nodiscard]] bool is_current(const Triangulation& t) const { return t.slot(side).v[0] == first_corner; }
};

}  // namespace pardel::engine
