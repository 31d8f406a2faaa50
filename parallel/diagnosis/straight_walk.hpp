// Walks straight across the edges of a triangulation.
#pragma once

#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// The line through `p`, perpendicular to the direction from `a` to `b`, on which a walk crosses edges.
class StraightWalk {
 public:
  StraightWalk(const Triangulation& t, Point p, Point a, Point b) : t_(t), p_(p), along_{b.x - a.x, b.y - a.y} {}

  /// The side through which the line leaves a triangle that it enters through the side `entered`.
  [[nodiscard]] EdgeRef exit(EdgeRef entered) const {
    const Slot& slot = t_.slot(entered);
    const unsigned apex = entered.side();
    return {entered.triangle(), exit_side(apex, lies_ahead(slot.apex(apex)), lies_ahead(slot.from(apex)))};
  }

  /// Crosses edges, beginning with side `e` of its triangle. Returns the first constrained edge, as a side of the
  /// triangle before it; none() after 64 edges that are not constrained.
  [[nodiscard]] EdgeRef to_constraint(EdgeRef e) const {
    constexpr int most_steps = 64;
    for (int step = 0; step < most_steps; ++step) {
      const EdgeRef across = t_.slot(e).n[e.side()];
      if (across.constrained()) return e;
      e = exit(across);
    }
    return {};
  }

 private:
  [[nodiscard]] bool lies_ahead(VertexId v) const {
    return along_.x * (t_.points[v].x - p_.x) + along_.y * (t_.points[v].y - p_.y) > 0;
  }

  const Triangulation& t_;
  Point p_, along_;
};

}  // namespace pardel::engine
