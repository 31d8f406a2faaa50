#include "insertion.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "../arithmetic/predicates.hpp"
#include "../triangulation/flips.hpp"
#include "../triangulation/held.hpp"
#include "../triangulation/paired_disk_query.hpp"
#include "make_room.hpp"

namespace pardel::engine {
namespace {

constexpr auto no_triangle = [](EdgeRef) { return false; };
constexpr auto any_vertex = [](VertexId) { return true; };
/// Returns a function that loads a vertex relative to p.
auto corners_around(const Triangulation& t, Point p) {
  return [&t, p](VertexId v) { return corner_around(Pair{p.x, p.y}, t.points[v]); };
}

}  // namespace

bool Insertion::measure_fan(Point p) {
  const std::span<const CavityEdge> boundary = cavity_.boundary();
  const std::size_t n = boundary.size();
  if (measures_.size() < n) {
    measures_.resize(2 * n);
    breaking_.resize(2 * n + 1);  // the loop below may write one entry beyond the last
  }
  Pair closest{INFINITY, INFINITY};
  bool visible = true;
  std::size_t breaking = 0;
  // Two edges at a time: from a to b, and from c to d. If the number of edges is odd, the last one is measured twice.
  for (std::size_t i = 0; i < n; i += 2) {
    const std::size_t j = std::min(i + 1, n - 1);
    const Corner a = cavity_.corner(i), b = cavity_.corner(i + 1), c = cavity_.corner(j), d = cavity_.corner(j + 1);
    const Pair start_x = firsts(a.at, c.at), start_y = seconds(a.at, c.at);
    const Pair end_x = firsts(b.at, d.at), end_y = seconds(b.at, d.at);
    const Pair edge_x = end_x - start_x, edge_y = end_y - start_y;
    const Pair start{a.square, c.square}, end{b.square, d.square};
    Pair edge = edge_x * edge_x + edge_y * edge_y, area = start_x * end_y - start_y * end_x;
    if (const auto fine = area >= share_of_thin * (start + end); !all(fine)) [[unlikely]] {
      for (const auto& [half, number] : {std::pair{0, i}, std::pair{1, j}}) {
        if ((bits(fine) >> half & 1) != 0) continue;
        const Measure thin = measure_of_thin(p, t_.points[boundary[number].from], t_.points[cavity_.to(number)]);
        edge[half] = thin.squared[0];
        area[half] = thin.twice_area;
      }
      visible = visible && all(area > 0);
    }
    closest = least(closest, least(start, end));
    const MeasureOf<Pair> both{{edge, end, start}, area};
    const unsigned breaks = bits(criteria_.bad_shape(both)) | bits(criteria_.too_large(both));
    measures_[i] = {{edge[0], end[0], start[0]}, area[0]};
    measures_[j] = {{edge[1], end[1], start[1]}, area[1]};
    // No branch here: a processor cannot predict which triangles are bad.
    breaking_[breaking] = i;
    breaking += breaks & 1;
    breaking_[breaking] = j;
    breaking += breaks >> 1 & static_cast<unsigned>(i < j);
  }
  breaking_count_ = breaking;
  squared_closest_ = std::min(closest[0], closest[1]);
  return visible;
}

// The premise of Theorem 2 (THEORY.md, T2): a point that encroaches on no constrained edge of its cavity makes no
// circumradius larger than the largest one so far (with lenses: than 1 / sin 2α times the largest one at the start).
EdgeRef Insertion::longest_encroached() const {
  double longest = 0;
  EdgeRef found, border;
  for (std::size_t i = 0; i < cavity_.boundary().size(); ++i) {
    const CavityEdge& edge = cavity_.boundary()[i];
    if (!edge.outer.constrained()) continue;
    const Measure& m = measures_[i];
    const double dot = m.dot_at(0), length = m.squared[0];
    if (t_.on_border_of_patch(edge.inner)) {
      if (m.twice_area <= 0 || criteria_.encroaches_on_patch(dot, m.squared[1], m.squared[2])) border = edge.inner;
      continue;
    }
    if ((m.twice_area <= 0 || criteria_.encroaches(dot, m.squared[1], m.squared[2])) && length > longest) {
      longest = length;
      found = edge.inner;
    }
  }
  return found.none() ? border : found;
}

// T-region (THEORY.md): tasks with disjoint boxes do not depend on each other if each inserts only points that lie in
// its box together with all corners of their cavities. Other points are `leaves_box`.
Outcome Insertion::try_in_face(Point p, TriangleId first, const Box& box) {
  if (!box.contains_half_open(p)) return Outcome::leaves_box;
  tried_ = p;
  tried_from_ = first;
  const Walk walk = cavity_.find(t_, first, PairedDiskQuery{t_, Pair{p.x, p.y}, box});
  if (walk == Walk::elsewhere) return Outcome::refused;
  if (walk == Walk::foreign) return Outcome::leaves_box;
  is_star_ = measure_fan(p) && walk == Walk::complete;

  blocker_ = cavity_.touches_constraint() ? longest_encroached() : EdgeRef();
  if (!blocker_.none()) return Outcome::encroaches;
  if (too_close(p)) return Outcome::too_close;
  // A complete cavity without a blocker is star-shaped. Let x lie inside one of its triangles. The segment from x to p
  // crosses triangles of the cavity only (THEORY.md, Lemma 1), as long as it crosses no constrained edge. If it does,
  // this edge belongs to the boundary of the cavity, and p lies on the line of the edge or beyond, so it is a blocker.
  return is_star_ ? Outcome::inserted : Outcome::refused;
}

Outcome Insertion::insert_in_face(Point p, TriangleId first, const Box& box) {
  const Outcome outcome = try_in_face(p, first, box);
  if (outcome == Outcome::inserted) insert_tried_in_face(p);
  return outcome;
}

void Insertion::insert_tried_in_face(Point p) { commit(p, interior_vertex); }

bool Insertion::left_box_for(Point p, const Box& box, double squared_circumradius) const {
  const auto is_small_outside = [&](EdgeRef across) {
    if (across.constrained()) return false;
    const Slot& slot = t_.slot(across);
    return !box.contains_half_open(t_.points[slot.v[across.side()]]) && in_circumdisk(t_, slot, p) &&
           Shape(t_, slot).squared_circumradius() <= squared_circumradius;
  };
  return std::any_of(cavity_.triangles().begin(), cavity_.triangles().end(), [&](TriangleId id) {
    const auto& n = t_.slots[id].n;
    return std::any_of(n.begin(), n.end(), is_small_outside);
  });
}

// The point and all corners of its cavity have to lie in the box, as in try_in_face() (THEORY.md, T-region).
Outcome Insertion::try_on_edge(Point p, EdgeRef e, const Box& box) {
  const EdgeRef other = t_.slot(e).n[e.side()];
  if (!box.contains_half_open(p)) return Outcome::leaves_box;
  tried_ = p;
  tried_from_ = e.triangle();
  for (const EdgeRef side : {e, other})
    if (!side.none())
      for (const VertexId v : t_.slot(side).v) {
        require_held(t_.points[v]);
        if (!box.contains_half_open(t_.points[v])) return Outcome::leaves_box;
      }
  const Walk walk = cavity_.find_on_edge(t_, e, PairedDiskQuery{t_, Pair{p.x, p.y}, box});
  if (walk == Walk::foreign) return Outcome::leaves_box;
  // The walk does not test the two triangles at the edge. Rounding may have moved p out of the disk of one of them.
  // Then the fan may be not Delaunay, and the walk may reach this triangle a second time, around a vertex that is
  // closer to the edge than p is. If p lies in all disks of the cavity and sees all of its boundary, the fan is
  // Delaunay in spite of the rounding: on the paraboloid, the lifted p lies below every lifted triangle of the cavity.
  const bool is_cavity = walk == Walk::complete && in_circumdisk(t_, t_.slot(e), p) &&
                         (other.none() || in_circumdisk(t_, t_.slot(other), p));
  is_star_ = measure_fan(p) && is_cavity;
  return too_close(p) ? Outcome::too_close : Outcome::inserted;
}

Outcome Insertion::split_edge(Point p, EdgeRef e, Index segment, const Box& box) {
  const Outcome outcome = try_on_edge(p, e, box);
  if (outcome != Outcome::inserted) return outcome;
  if (!is_star_) return box.is_whole_plane() ? edge_by_flips(p, e, segment) : Outcome::leaves_box;
  commit(p, origin_on_segment(segment));
  return outcome;
}

std::vector<VertexId> Insertion::ends_of_missed_edges() const {
  std::vector<VertexId> ends;
  if (tried_from_ == no_index) return ends;
  std::set<TriangleId> found{tried_from_};
  std::vector<TriangleId> next{tried_from_};
  while (!next.empty()) {
    const Slot& slot = t_.slots[next.back()];
    next.pop_back();
    for (unsigned side = 0; side < 3; ++side) {
      const EdgeRef across = slot.n[side];
      if (across.none()) continue;
      if (!is_held(t_, across.triangle()))
        ends.insert(ends.end(), {slot.from(side), slot.to(side)});
      else if (!across.constrained() && in_circumdisk(t_, t_.slot(across), tried_) &&
               found.insert(across.triangle()).second)
        next.push_back(across.triangle());
    }
  }
  return ends;
}

void Insertion::commit(Point p, Index origin) {
  tried_from_ = no_index;
  const VertexId v = free_->vertices.take();
  t_.points[v] = p;
  t_.origin[v] = origin;
  changed_ = retriangulate(t_, cavity_, v, [this] { return free_->triangles.take(); });
  is_measured_ = true;
}

/// Used if rounding has moved p so far that its cavity is not star-shaped.
Outcome Insertion::edge_by_flips(Point p, EdgeRef e, Index segment) {
  flipped_.clear();
  e = make_room(t_, e, p, flipped_);
  if (e.none()) return Outcome::refused;
  // Only the two triangles at e are replaced. Since there is room, p sees their other sides, and the fan is positive.
  const auto corners = corners_around(t_, p);
  static_cast<void>(cavity_.find_on_edge(t_, e, SingleTriangleQuery(t_, no_triangle, corners, any_vertex)));
  commit(p, origin_on_segment(segment));
  finish_by_flips();
  return Outcome::inserted;
}

/// flipped_: the triangles that room was made with.
void Insertion::finish_by_flips() {
  has_flipped_ = true;
  is_measured_ = false;
  std::vector<EdgeRef> suspects;
  for (const TriangleId id : flipped_)
    suspects.insert(suspects.end(), {EdgeRef(id, 0), EdgeRef(id, 1), EdgeRef(id, 2)});
  for (const TriangleId id : changed_) suspects.insert(suspects.end(), {EdgeRef(id, 0), EdgeRef(id, 1)});
  flipped_.insert(flipped_.end(), changed_.begin(), changed_.end());
  restore_delaunay(t_, std::move(suspects), flipped_);
  changed_ = flipped_;
}

}  // namespace pardel::engine
