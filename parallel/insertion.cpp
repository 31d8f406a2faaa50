#include "insertion.hpp"

#include <algorithm>

#include "../core/mutants.hpp"
#include "flips.hpp"
#include "predicates.hpp"

namespace pardel {
namespace {

constexpr auto nothing_else = [](TriangleId, unsigned) { return Reach::outside; };

}  // namespace

bool Insertion::measure_fan(Point p) {
  const auto boundary = cavity_.boundary();
  const std::size_t n = boundary.size();
  measures_.resize(n);
  Point a = t_.points[boundary[0].from];
  double squared_a = (a.x - p.x) * (a.x - p.x) + (a.y - p.y) * (a.y - p.y);
  squared_closest_ = squared_a;
  bool visible = true;
  for (std::size_t i = 0; i < n; ++i) {
    const Point b = t_.points[cavity_.to(i)];
    const double squared_b = (b.x - p.x) * (b.x - p.x) + (b.y - p.y) * (b.y - p.y);
    const double area = orient2d(a, b, p);
    visible = visible && (mutated("orientation_of_the_fan_not_checked") || area > 0);
    squared_closest_ = std::min(squared_closest_, squared_b);
    measures_[i] = {{(b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y), squared_b, squared_a}, area};
    a = b;
    squared_a = squared_b;
  }
  return visible;
}

EdgeRef Insertion::longest_encroached() const {
  if (mutated("encroachment_skipped")) return {};
  double longest = 0, longest_wide = 0;
  EdgeRef found, wide;  // wide: its whole diametral disk, not only the lens, contains the point
  for (std::size_t i = 0; i < measures_.size(); ++i) {
    const CavityEdge& edge = cavity_.boundary()[i];
    if (!edge.outer.constrained()) continue;
    const Measure& m = measures_[i];
    const double dot = m.dot_at(0), length = m.squared[0];
    if ((m.twice_area <= 0 || criteria_.encroaches(dot, m.squared[1], m.squared[2])) && length > longest) {
      longest = length;
      found = edge.inner;
    }
    if (dot <= 0 && length > longest_wide) {
      longest_wide = length;
      wide = edge.inner;
    }
  }
  // Where a constrained edge is not Delaunay the cavity may hold triangles that the point does not see.
  return found.none() && !is_star_ ? wide : found;
}

Outcome Insertion::try_in_face(Point p, TriangleId first, const Box& box) {
  if (!box.contains(p)) return Outcome::leaves_box;
  if (!disk_contains(t_.slots[first], p)) return Outcome::refused;
  const Walk walk = cavity_.find(t_, first, reach_within(p, box));
  if (walk == Walk::foreign) return Outcome::leaves_box;
  is_star_ = measure_fan(p) && walk == Walk::complete;

  blocker_ = cavity_.touches_constraint() ? longest_encroached() : EdgeRef();
  if (!blocker_.none()) return Outcome::encroaches;
  if (too_close()) return Outcome::too_close;
  return walk == Walk::tangled ? Outcome::refused : Outcome::inserted;
}

Outcome Insertion::insert_in_face(Point p, TriangleId first, const Box& box) {
  const Outcome outcome = try_in_face(p, first, box);
  if (outcome != Outcome::inserted) return outcome;
  if (!is_star_) return box.is_everything() ? face_by_flips(p) : Outcome::leaves_box;
  commit(p, interior_vertex);
  return outcome;
}

bool Insertion::left_box_for(Point p, const Box& box, double squared_circumradius) const {
  const auto is_it = [&](EdgeRef across) {
    if (across.constrained()) return false;
    const Slot& slot = t_.slot(across);
    return !box.contains(t_.points[slot.v[across.side()]]) && disk_contains(slot, p) &&
           Shape(t_, slot).squared_circumradius() <= squared_circumradius;
  };
  return std::any_of(cavity_.triangles().begin(), cavity_.triangles().end(), [&](TriangleId id) {
    const auto& n = t_.slots[id].n;
    return std::any_of(n.begin(), n.end(), is_it);
  });
}

Outcome Insertion::try_on_edge(Point p, EdgeRef e, const Box& box) {
  const EdgeRef other = t_.slot(e).n[e.side()];
  if (!box.contains(p)) return Outcome::leaves_box;
  for (const EdgeRef side : {e, other})
    if (!side.none())
      for (const VertexId v : t_.slot(side).v)
        if (!box.contains(t_.points[v])) return Outcome::leaves_box;
  const Walk walk = cavity_.find_on_edge(t_, e, reach_within(p, box));
  if (walk == Walk::foreign) return Outcome::leaves_box;
  // The walk takes the triangles at the edge for granted. Where rounding put p outside the disk of one, the fan need
  // not be Delaunay, and the walk may come upon that triangle again from behind, around a vertex that is closer to the
  // edge than p is. Inside all disks of the cavity, and with p seeing all of its boundary, the fan is Delaunay wherever
  // rounding put p: lifted to the paraboloid, p lies below every triangle of the cavity.
  const bool is_cavity =
      walk == Walk::complete && disk_contains(t_.slot(e), p) && (other.none() || disk_contains(t_.slot(other), p));
  is_star_ = measure_fan(p) && is_cavity;
  return too_close() ? Outcome::too_close : Outcome::inserted;
}

Outcome Insertion::split_edge(Point p, EdgeRef e, Index line, const Box& box) {
  const Outcome outcome = try_on_edge(p, e, box);
  if (outcome != Outcome::inserted) return outcome;
  if (!is_star_) return box.is_everything() ? edge_by_flips(p, e, line) : Outcome::leaves_box;
  commit(p, line);
  return outcome;
}

void Insertion::commit(Point p, Index origin) {
  const VertexId v = supply_->vertices.take();
  t_.points[v] = p;
  t_.origin[v] = origin;
  retriangulate(
      t_, cavity_, v, [this] { return supply_->triangles.take(); }, fan_);
}

/// The cavity was found not to be star-shaped: split the triangle of it that contains p, then flip.
Outcome Insertion::face_by_flips(Point p) {
  const std::vector<TriangleId> candidates(cavity_.triangles().begin(), cavity_.triangles().end());
  for (const TriangleId id : candidates) {
    const Slot& slot = t_.slots[id];
    EdgeRef on;
    bool inside = true;
    for (unsigned side = 0; side < 3 && inside; ++side) {
      const double o = orient2d(t_.points[slot.from(side)], t_.points[slot.to(side)], p);
      inside = o >= 0;
      if (o == 0) on = slot.n[side];
    }
    if (!inside) continue;
    const auto across_only = [&](TriangleId other, unsigned) {
      return !on.none() && other == on.triangle() ? Reach::inside : Reach::outside;
    };
    if (cavity_.find(t_, id, across_only) != Walk::complete || !measure_fan(p)) return Outcome::refused;
    commit(p, interior_vertex);
    finish_by_flips();
    return Outcome::inserted;
  }
  return Outcome::refused;
}

Outcome Insertion::edge_by_flips(Point p, EdgeRef e, Index line) {
  if (cavity_.find_on_edge(t_, e, nothing_else) != Walk::complete || !measure_fan(p)) return Outcome::refused;
  commit(p, line);
  finish_by_flips();
  return Outcome::inserted;
}

void Insertion::finish_by_flips() {
  has_flipped_ = true;
  measures_.clear();
  std::vector<EdgeRef> suspects;
  for (const TriangleId id : fan_) suspects.insert(suspects.end(), {EdgeRef(id, 0), EdgeRef(id, 1)});
  restore_delaunay(t_, std::move(suspects), fan_);
}

}  // namespace pardel
