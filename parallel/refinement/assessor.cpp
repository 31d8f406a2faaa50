#include "assessor.hpp"

#include <algorithm>

#include "../arithmetic/between_ends.hpp"
#include "../arithmetic/distance.hpp"
#include "../triangulation/flips.hpp"

namespace pardel::engine {

bool Assessor::forbidden(EdgeRef e) const {
  if (t_.on_border_of_patch(e)) return true;  // it is part of no segment
  return options_.no_segment_splits || (options_.no_boundary_splits && t_.slot(e).n[e.side()].none()) ||
         (!options_.kept_markers.empty() && on_kept_segment(e));
}

bool Assessor::on_kept_segment(EdgeRef e) const {
  const Slot& slot = t_.slot(e);
  const Point middle = middle_of(t_.points[slot.from(e.side())], t_.points[slot.to(e.side())]);
  const int marker = segments_.marker_of_edge(t_.points, segment_of(e), middle, slot.n[e.side()].none());
  return std::ranges::find(options_.kept_markers, marker) != options_.kept_markers.end();
}

bool Assessor::below_floor(EdgeRef e) const {
  const Point a = t_.points[t_.slot(e).from(e.side())], b = t_.points[t_.slot(e).to(e.side())];
  const double floor = floor_.along(a, b);
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) < 4 * floor * floor;
}

bool Assessor::undercuts_floor(EdgeRef side) const {
  const Slot& slot = t_.slot(side);
  const Point a = t_.points[slot.from(side.side())];
  return distance(a, t_.points[slot.to(side.side())]) < floor_.at(a);
}

/// The first constrained side that has to be split and may be split; 3 if there is no such side.
unsigned Assessor::encroached_side(TriangleId id, const Slot& slot, const Measure& m) const {
  unsigned side = 0;
  for (; side < 3; ++side) {
    if (!slot.n[side].constrained()) continue;
    const EdgeRef e(id, side);
    const bool encroached =
        criteria_.encroaches(m.dot_at(side), m.squared[next_corner[side]], m.squared[previous_corner[side]]) ||
        (criteria_.conforming() && !slot.n[side].none() && !delaunay_across(t_, e));
    if (encroached && !forbidden(e) && !below_floor(e)) break;
  }
  return side;
}

Assessment Assessor::assess_at_constraint(TriangleId id, const Measure& m, LocalHints& hints) const {
  const unsigned side = encroached_side(id, t_.slots[id], m);
  if (side < 3)
    return {Assessment::Need::split_edge, side, BucketQueue::urgent, m.longest_squared(), /*left_alone=*/false};
  Assessment result = assess_inside(id, m, hints);
  result.left_alone = result.left_alone || non_delaunay_side(id) < 3;
  return result;
}

/// The corners have another order in split_point(), so its centroid may be rounded to another place.
void Assessor::announce(std::span<const TriangleId> triangles, std::span<const Measure> measures) const {
  std::vector<Point> places;
  places.reserve(2 * triangles.size());
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const auto& v = t_.slots[triangles[k]].v;
    const unsigned apex = measures[k].shortest_side(), from = next_corner[apex], to = previous_corner[apex];
    places.push_back(centroid_of(t_.points[v[0]], t_.points[v[1]], t_.points[v[2]]));
    const Point split = centroid_of(t_.points[v[from]], t_.points[v[to]], t_.points[v[apex]]);
    if (split != places.back()) places.push_back(split);
  }
  criteria_.announce(places);
}

bool Assessor::breaks_goal(TriangleId id, LocalHints& hints) const {
  const Shape shape(t_, t_.slots[id]);
  return criteria_.bad_shape(shape) || too_large(id, shape, hints) || non_delaunay_side(id) < 3;
}

unsigned Assessor::find_non_delaunay_side(TriangleId id) const {
  unsigned side = 0;
  while (side < 3 && !is_non_delaunay_segment(EdgeRef(id, side))) ++side;
  return side;
}

bool Assessor::is_non_delaunay_segment(EdgeRef side) const {
  const EdgeRef across = t_.slot(side).n[side.side()];
  return across.constrained() && !across.none() && !delaunay_across(t_, side);
}

Index Assessor::segment_of(EdgeRef e) const {
  const Slot& slot = t_.slot(e);
  return segments_.segment_of(t_, slot.from(e.side()), slot.to(e.side()));
}

Point Assessor::point_on(EdgeRef e) const {
  const Slot& slot = t_.slot(e);
  const VertexId a = slot.from(e.side()), b = slot.to(e.side());
  return edge_split_point(t_, segments_, segment_of(e), a, b, floor_.along(t_.points[a], t_.points[b]),
                          criteria_.length_of_pieces(region_of(e.triangle())));
}

std::vector<Point> Assessor::other_points_on(EdgeRef e, TriangleId on_behalf_of, LocalHints& hints) const {
  if (!too_large(on_behalf_of, hints)) return {};
  const Slot& slot = t_.slot(e);
  return other_edge_split_points(t_, segments_, segment_of(e), slot.from(e.side()), slot.to(e.side()));
}

Point Assessor::point_for(TriangleId id, const Assessment& a, LocalHints& hints) const {
  const EdgeRef side(id, a.side);
  return a.need == Assessment::Need::split_edge ? point_on(side) : point_in(side, hints);
}

}  // namespace pardel::engine
