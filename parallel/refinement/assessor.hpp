// What is to be done about a triangle: the decisions of the refinement.
#pragma once

#include <cassert>

#include "../options.hpp"
#include "../triangulation/domain_segments.hpp"
#include "bucket_queue.hpp"
#include "criteria.hpp"
#include "small_angles.hpp"

namespace pardel::engine {

/// What a triangle asks for.
struct Assessment {
  enum class Need : std::uint8_t { nothing, split_edge, split_triangle };
  Need need = Need::nothing;
  unsigned side = 0;  ///< the side to split, or of a triangle to split its shortest
  unsigned key = 0;   ///< its place in the queue
  double longest_squared = 0;
  bool left_alone = false;  ///< breaks the goal, but nothing is to be done about it
};

/// The decisions of the refinement: pure functions of the triangulation.
class Judge {
 public:
  Judge(const Triangulation& t, const DomainSegments& segments, const Criteria& criteria, const Options& options)
      : t_(t),
        segments_(segments),
        criteria_(criteria),
        options_(options),
        squared_floor_(options.min_edge * options.min_edge) {}

  /// The triangle as it is now, with the side that its assessment is about.
  [[nodiscard]] Queued queued(TriangleId id, const Assessment& a) const {
    return {EdgeRef(id, a.side), t_.slots[id].v[0]};
  }
  /// Whether the slot still holds the triangle that was queued.
  [[nodiscard]] bool is_current(Queued q) const { return t_.slots[q.id()].v[0] == q.first_corner; }
  [[nodiscard]] Assessment assess(TriangleId id) const { return assess(id, Shape(t_, t_.slots[id])); }
  [[nodiscard]] Assessment assess(TriangleId id, const Measure& m) const {
    return t_.slots[id].any_constrained() ? assess_beside_constraint(id, m) : assess_inside(id, m);
  }
  /// The same for a triangle whose sides cannot be split, encroached or not.
  [[nodiscard]] Assessment assess_inside(TriangleId id) const { return assess_inside(id, Shape(t_, t_.slots[id])); }
  [[nodiscard]] Assessment assess_inside(TriangleId id, const Measure& m) const {
    const bool large = too_large(id, m);
    if (!large && !criteria_.bad_shape(m)) return {};
    const double shortest = m.shortest_squared();
    if (shortest < squared_floor_ || (!large && small_angle(t_, segments_, t_.slots[id], m)))
      return {.left_alone = true};
    return {Assessment::Need::split_triangle, m.shortest_side(), BucketQueue::key(shortest), m.longest_squared(),
            false};
  }
  [[nodiscard]] bool has_local_size() const { return criteria_.has_local_size(); }
  /// Breaks the criteria, justified or not.
  [[nodiscard]] bool breaks_goal(TriangleId id) const;
  /// A constrained side that a conforming goal wants Delaunay and that is not, or 3.
  [[nodiscard]] unsigned non_delaunay_side(TriangleId id) const;
  [[nodiscard]] bool forbidden(EdgeRef e) const;  ///< may not be split by the caller's wish
  [[nodiscard]] bool below_floor(EdgeRef e) const;
  [[nodiscard]] bool too_large(TriangleId id) const { return too_large(id, Shape(t_, t_.slots[id])); }
  /// The point that the assessment's need puts in.
  [[nodiscard]] Point point_for(TriangleId id, const Assessment& a) const;
  [[nodiscard]] Point point_on(EdgeRef e) const;
  /// For a triangle by its shortest side.
  [[nodiscard]] Point point_in(EdgeRef shortest) const {
    const Slot& slot = t_.slot(shortest);
    const unsigned side = shortest.side();
    assert(side == Shape(t_, slot).shortest_side());
    return criteria_.split_point(t_.points[slot.from(side)], t_.points[slot.to(side)], t_.points[slot.apex(side)],
                                 region_of(shortest.triangle()));
  }
  [[nodiscard]] Index segment_of(EdgeRef e) const;
  [[nodiscard]] Index region_of(TriangleId id) const { return t_.region.empty() ? no_index : t_.region[id]; }

 private:
  [[nodiscard]] Assessment assess_beside_constraint(TriangleId id, const Measure& m) const;
  [[nodiscard]] unsigned encroached_side(TriangleId id, const Slot& slot, const Measure& m) const;
  [[nodiscard]] bool too_large(TriangleId id, const Measure& m) const {
    return criteria_.too_large(m) ||
           (criteria_.has_local_size() && criteria_.too_large_locally(Shape(t_, t_.slots[id]), region_of(id)));
  }

  const Triangulation& t_;
  const DomainSegments& segments_;
  const Criteria& criteria_;
  const Options& options_;
  double squared_floor_;
};

}  // namespace pardel::engine
