#include "bowyer_watson.hpp"

#include "../arithmetic/predicates.hpp"
#include "../triangulation/in_circumdisk.hpp"
#include "../triangulation/locate.hpp"

namespace pardel::engine {
namespace {

/// The open disk of a ghost triangle is the open half-plane beyond its hull edge, together with the interior of the
/// edge.
bool ghost_disk_contains(const Triangulation& t, const Slot& slot, Point p) {
  const unsigned corner = slot.corner_of(ghost);
  const Point a = t.points[slot.from(corner)], b = t.points[slot.to(corner)];
  const double side = orient2d(a, b, p);
  if (side != 0) return side > 0;
  return (a.x < p.x && p.x < b.x) || (b.x < p.x && p.x < a.x) || (a.y < p.y && p.y < b.y) || (b.y < p.y && p.y < a.y);
}

bool disk_contains(const Triangulation& t, TriangleId id, Point p) {
  const Slot& slot = t.slots[id];
  if (slot.is_ghost()) return ghost_disk_contains(t, slot, p);
  return in_circumdisk(t, slot, p);
}

constexpr auto no_corners = [](VertexId) { return Corner{}; };

}  // namespace

Inserted BowyerWatson::insert(VertexId v, TriangleId fresh) {
  const Point p = t_.points[v];
  const TriangleId first = locate(t_, p, near_, [this](VertexId apex) { return in_box(apex); });
  if (first == no_index) return Inserted::leaves_box;
  if (!disk_contains(t_, first, p)) return Inserted::duplicate;
  const auto is_hit = [&](EdgeRef e) { return disk_contains(t_, e.triangle(), p); };
  const auto is_own = [&](VertexId apex) { return in_box(apex); };
  const Walk walk = cavity_.find(t_, first, SingleTriangleQuery(t_, is_hit, no_corners, is_own));
  if (walk == Walk::foreign) return Inserted::leaves_box;
  if (walk == Walk::tangled) return Inserted::inconsistent;
  for (const TriangleId id : retriangulate(t_, cavity_, v, [&] { return fresh++; }))
    if (!t_.slots[id].is_ghost()) {
      near_ = id;
      break;
    }
  return Inserted::yes;
}

}  // namespace pardel::engine
