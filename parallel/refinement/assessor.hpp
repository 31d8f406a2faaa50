// Determines if a triangle has to be split, and at which point.
#pragma once

#include <cassert>
#include <cmath>
#include <span>
#include <vector>

#include "../arithmetic/box.hpp"
#include "../arithmetic/floor.hpp"
#include "../options.hpp"
#include "../quality/criteria.hpp"
#include "../quality/small_angles.hpp"
#include "../triangulation/domain_segments.hpp"
#include "bucket_queue.hpp"
#include "queued_triangle.hpp"

namespace pardel::engine {

/// The result of the assessment of a triangle: the split that it needs.
struct Assessment {
  enum class Need : std::uint8_t { nothing, split_edge, split_triangle };
  Need need = Need::nothing;
  unsigned side = 0;  ///< split_edge: the side to split; split_triangle: the shortest side
  unsigned key = 0;   ///< the triangle's key in the queue
  double longest_squared = 0;
  bool left_alone = false;  ///< the triangle breaks the goal, but it may not or cannot be split
};

/// Assesses triangles. All functions are pure functions of the triangulation. Hints (those of the calling thread) make
/// them faster; functions without hints are for a few triangles.
class Assessor {
 public:
  Assessor(const Triangulation& t, const DomainSegments& segments, const Criteria& criteria, const Options& options)
      : t_(t), segments_(segments), criteria_(criteria), options_(options), floor_(options.min_edge) {}

  /// All vertices lie in this box, and will. This makes assessments faster, and changes no result.
  void expect_within(const Box& bounds) { squared_highest_floor_ = floor_.squared_at({bounds.largest_magnitude(), 0}); }

  /// The queue entry for the triangle that the slot `id` holds now, with the side from its assessment.
  [[nodiscard]] QueuedTriangle entry(TriangleId id, const Assessment& a) const {
    return QueuedTriangle::now(t_, EdgeRef(id, a.side));
  }
  [[nodiscard]] Assessment assess(TriangleId id) const {
    LocalHints none;
    return assess(id, none);
  }
  [[nodiscard]] Assessment assess(TriangleId id, LocalHints& hints) const {
    return assess(id, Shape(t_, t_.slots[id]), hints);
  }
  [[nodiscard]] Assessment assess(TriangleId id, const Measure& m, LocalHints& hints) const {
    return t_.slots[id].any_constrained() ? assess_at_constraint(id, m, hints) : assess_inside(id, m, hints);
  }
  /// The same for a triangle whose sides cannot be split, whether they are encroached or not.
  [[nodiscard]] Assessment assess_inside(TriangleId id) const {
    LocalHints none;
    return assess_inside(id, none);
  }
  [[nodiscard]] Assessment assess_inside(TriangleId id, LocalHints& hints) const {
    return assess_inside(id, Shape(t_, t_.slots[id]), hints);
  }
  [[nodiscard]] Assessment assess_inside(TriangleId id, const Measure& m, LocalHints& hints) const {
    const bool large = too_large(id, m, hints);
    if (!large && !criteria_.bad_shape(m)) return {};
    if (below_floor(id, m) || (!large && small_angle(t_, segments_, criteria_, t_.slots[id], m)))
      return {.left_alone = true};
    return {Assessment::Need::split_triangle, m.shortest_side(), BucketQueue::key(m.shortest_squared()),
            m.longest_squared(), false};
  }
  [[nodiscard]] bool has_local_size() const { return criteria_.has_local_size(); }
  [[nodiscard]] bool searches() const { return criteria_.searches(); }
  /// Prepares for triangles whose first corner is v. It changes no result.
  void look_around(VertexId v, LocalHints& hints) const { criteria_.look_around(t_.points[v], hints); }
  [[nodiscard]] bool announces_places() const { return criteria_.announces_places(); }
  /// Announces where the sizes of triangles will be asked for. Precondition: announces_places().
  void announce(std::span<const TriangleId> triangles, std::span<const Measure> measures) const;
  /// True if the triangle breaks the criteria, even if an exemption justifies this.
  [[nodiscard]] bool breaks_goal(TriangleId id, LocalHints& hints) const;
  [[nodiscard]] bool breaks_goal(TriangleId id) const {
    LocalHints none;
    return breaks_goal(id, none);
  }
  /// For a conforming goal: a constrained side that is not Delaunay, or 3 if there is none. For other goals: 3.
  [[nodiscard]] unsigned non_delaunay_side(TriangleId id) const {
    return criteria_.conforming() ? find_non_delaunay_side(id) : 3;
  }
  /// True if the side is constrained, has triangles on both sides, and is not Delaunay.
  [[nodiscard]] bool is_non_delaunay_segment(EdgeRef side) const;
  /// True if the options do not allow to split the edge, or if it lies on the border of a patch.
  [[nodiscard]] bool forbidden(EdgeRef e) const;
  /// True if the halves of the edge would be shorter than the floor.
  [[nodiscard]] bool below_floor(EdgeRef e) const;
  /// True if the shortest side of the triangle is shorter than the floor where this side begins.
  [[nodiscard]] bool below_floor(TriangleId id, const Measure& m) const {
    return m.shortest_squared() < squared_highest_floor_ && undercuts_floor(EdgeRef(id, m.shortest_side()));
  }
  [[nodiscard]] bool too_large(TriangleId id, LocalHints& hints) const {
    return too_large(id, Shape(t_, t_.slots[id]), hints);
  }
  /// The point that has to be inserted. Precondition: the assessment's need is not `nothing`.
  [[nodiscard]] Point point_for(TriangleId id, const Assessment& a, LocalHints& hints) const;
  [[nodiscard]] Point point_for(TriangleId id, const Assessment& a) const {
    LocalHints none;
    return point_for(id, a, none);
  }
  /// The point that splits the constrained edge e.
  [[nodiscard]] Point point_on(EdgeRef e) const;
  /// The points that split it on behalf of a triangle that is too large if point_on() cannot be inserted. None for
  /// other triangles: with the bound on angles alone, they could bring about splits down to the floor.
  [[nodiscard]] std::vector<Point> other_points_on(EdgeRef e, TriangleId on_behalf_of, LocalHints& hints) const;
  /// The point that splits a triangle, given the triangle's shortest side.
  [[nodiscard]] Point point_in(EdgeRef shortest, LocalHints& hints) const {
    const Slot& slot = t_.slot(shortest);
    const unsigned side = shortest.side();
    assert(side == Shape(t_, slot).shortest_side());
    return criteria_.split_point(t_.points[slot.from(side)], t_.points[slot.to(side)], t_.points[slot.apex(side)],
                                 region_of(shortest.triangle()), hints);
  }
  /// True if splitting e, a part of `segment`, at p leaves the segment clear of others outside the domain.
  [[nodiscard]] bool may_split(EdgeRef e, Index segment, Point p) const {
    if (!segments_.has_clearances()) return true;
    const Slot& slot = t_.slot(e);
    return segments_.may_split(t_.points, segment, {t_.points[slot.from(e.side())], t_.points[slot.to(e.side())]}, p);
  }
  /// The input segment on which the constrained edge e lies.
  [[nodiscard]] Index segment_of(EdgeRef e) const;
  /// The region of a triangle; no_index if the domain has only one region.
  [[nodiscard]] Index region_of(TriangleId id) const { return t_.region.empty() ? no_index : t_.region[id]; }

 private:
  /// True if the edge lies on a segment with one of Options::kept_markers.
  [[nodiscard]] bool on_kept_segment(EdgeRef e) const;
  /// True if the side is shorter than the floor where it begins. Measures of triangles do not tell: they are rounded by
  /// the distance of the far corner.
  [[nodiscard]] bool undercuts_floor(EdgeRef side) const;
  [[nodiscard]] unsigned find_non_delaunay_side(TriangleId id) const;
  [[nodiscard]] Assessment assess_at_constraint(TriangleId id, const Measure& m, LocalHints& hints) const;
  [[nodiscard]] unsigned encroached_side(TriangleId id, const Slot& slot, const Measure& m) const;
  [[nodiscard]] bool too_large(TriangleId id, const Measure& m, LocalHints& hints) const {
    if (criteria_.too_large(m)) return true;
    if (!criteria_.has_local_size()) return false;
    const auto& v = t_.slots[id].v;
    return criteria_.too_large_locally(m, t_.points[v[0]], t_.points[v[1]], t_.points[v[2]], region_of(id), hints);
  }

  const Triangulation& t_;
  const DomainSegments& segments_;
  const Criteria& criteria_;
  const Options& options_;
  Floor floor_;
  double squared_highest_floor_ = INFINITY;
};

}  // namespace pardel::engine
