#include "bowyer_watson.hpp"

#include <utility>

#include "../arithmetic/predicates.hpp"
#include "../triangulation/paired_disk_query.hpp"

namespace pardel::engine {
namespace {

bool ghost_disk_contains(const Triangulation& t, const Slot& slot, Point p) {
  const unsigned corner = slot.corner_of(ghost);
  const Point a = t.points[slot.from(corner)], b = t.points[slot.to(corner)];
  const double side = orient2d(a, b, p);
  if (side != 0) return side > 0;
  return (a.x < p.x && p.x < b.x) || (b.x < p.x && p.x < a.x) || (a.y < p.y && p.y < b.y) || (b.y < p.y && p.y < a.y);
}

/// Which triangles' disks contain a vertex that is inserted.
struct VertexInDisks {
  const Triangulation& t;
  const InsertionOrder& order;
  VertexId v;
  Point p;

  [[nodiscard, gnu::always_inline]] bool operator()(const Slot& slot) const {
    if (slot.is_ghost()) return ghost_disk_contains(t, slot, p);
    const double sign = incircle(t.points[slot.v[0]], t.points[slot.v[1]], t.points[slot.v[2]], p);
    if (sign == 0) [[unlikely]]
      return counts_as_inside(t, slot.v, v, order);
    return sign > 0;
  }
};

constexpr auto no_corners = [](VertexId) { return Corner{}; };

/// The query of a box that does not hold the vertex at infinity. The walk over the cavity ends before it enters a ghost
/// triangle, so all corners that it passes to the query are vertices.
struct FiniteBoxQuery {
  const Triangulation& t;
  Pair p;
  const Box& box;
  VertexInDisks in_disk;
  PairedDiskQueryWith<VertexInDisks> pairs{t, p, box, in_disk};

  [[nodiscard]] bool is_own(VertexId v) const { return v != ghost && pairs.is_own(v); }
  [[nodiscard]] Corner corner(VertexId v) const { return v == ghost ? Corner{} : pairs.corner(v); }
  [[nodiscard]] InDisks first_and_behind(const Slot& first, const std::array<Corner, 3>& c, EdgeRef behind) const {
    if (far_corner(behind) == ghost) [[unlikely]]
      return InDisks::of(in_disk(first), in_disk(t.slot(behind)));
    return pairs.first_and_behind(first, c, behind);
  }
  [[nodiscard, gnu::always_inline]] DisksAndCorners both(Corner u, Corner w, Corner v, EdgeRef right,
                                                         EdgeRef left) const {
    const VertexId on_right = far_corner(right), on_left = far_corner(left);
    if (on_right == ghost || on_left == ghost) [[unlikely]]
      return {InDisks::of(in_disk(t.slot(right)), in_disk(t.slot(left))), {corner(on_right), corner(on_left)}};
    return pairs.both(u, w, v, right, left);
  }

 private:
  [[nodiscard]] VertexId far_corner(EdgeRef e) const { return t.slot(e).apex(e.side()); }
};

}  // namespace

bool is_in_disk(const Triangulation& t, const Slot& slot, VertexId v, const InsertionOrder& order) {
  return VertexInDisks{t, order, v, t.points[v]}(slot);
}

TriangleId BowyerWatson::locate(Point point) const {
  const Pair p = as_pair(point);
  const auto relative = [&](VertexId v) { return as_pair(t_.points[v]) - p; };
  // The walk is in the triangle behind `entered`. It came across this side, which runs from a to b; p is not beyond it.
  EdgeRef entered(near_, 0);
  const Slot& start = t_.slots[near_];
  Pair a = relative(start.v[1]), b = relative(start.v[2]);
  if (orient2d(t_.points[start.v[1]], t_.points[start.v[2]], point) < 0) {
    entered = start.n[0];
    std::swap(a, b);
  }
  for (;;) {
    const Slot& slot = t_.slot(entered);
    const unsigned side = entered.side();
    const VertexId apex = slot.apex(side);
    if (entered.triangle() != near_ && !in_box(apex)) return no_index;
    if (apex == ghost) return entered.triangle();
    const Pair c = relative(apex);
    const Orientation<Pair> turns(firsts(b, c), seconds(b, c), firsts(c, a), seconds(c, a));
    unsigned beyond = bits(turns.determinant < 0);
    if (!turns.is_certain()) [[unlikely]] {
      const Point from = t_.points[slot.from(side)], to = t_.points[slot.to(side)], far = t_.points[apex];
      beyond = InDisks::of(orient2d(to, far, point) < 0, orient2d(far, from, point) < 0).bits;
    }
    if (beyond == 0) return entered.triangle();
    if ((beyond & 1U) != 0) {
      entered = slot.n[next_corner[side]];
      a = c;
    } else {
      entered = slot.n[previous_corner[side]];
      b = c;
    }
  }
}

Inserted BowyerWatson::insert(VertexId v, TriangleId fresh) {
  const Point p = t_.points[v];
  const TriangleId first = locate(p);
  if (first == no_index) return Inserted::leaves_box;
  const Walk walk = find_cavity(first, v);
  if (walk == Walk::elsewhere) return Inserted::duplicate;
  if (walk == Walk::foreign) return Inserted::leaves_box;
  if (walk == Walk::tangled) return Inserted::inconsistent;
  made_ = retriangulate(t_, cavity_, v, [&] { return fresh++; });
  for (const TriangleId id : made_)
    if (!t_.slots[id].is_ghost()) {
      near_ = id;
      break;
    }
  return Inserted::yes;
}

Walk BowyerWatson::find_cavity(TriangleId first, VertexId v) {
  const VertexInDisks in_disk{t_, order_, v, t_.points[v]};
  if (!holds_infinity_) return cavity_.find(t_, first, FiniteBoxQuery{t_, as_pair(t_.points[v]), box_, in_disk});
  if (!in_disk(t_.slots[first])) return Walk::elsewhere;
  const auto is_hit = [&](EdgeRef e) { return in_disk(t_.slot(e)); };
  const auto is_own = [](VertexId) { return true; };
  return cavity_.find(t_, first, SingleTriangleQuery(t_, is_hit, no_corners, is_own));
}

}  // namespace pardel::engine
