#include <algorithm>

#include "constrain.hpp"
#include "delaunay.hpp"

namespace pardel {
namespace {

/// Marks what can be reached from the triangles on the stack without crossing a constrained edge.
void flood(const Triangulation& t, std::vector<TriangleId>& stack, Array<Index>& label, Index value) {
  while (!stack.empty()) {
    const TriangleId id = stack.back();
    stack.pop_back();
    if (label[id] == value) continue;
    label[id] = value;
    for (const EdgeRef out : t.slots[id].n)
      if (!out.constrained() && label[out.triangle()] != value) stack.push_back(out.triangle());
  }
}

std::vector<Constraint> constrain_hull(Triangulation& t) {
  std::vector<Constraint> fresh;
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    const Slot slot = t.slots[id];
    if (!slot.is_ghost()) continue;
    const unsigned corner = slot.v[0] == ghost ? 0 : slot.v[1] == ghost ? 1 : 2;
    if (slot.n[corner].constrained()) continue;
    t.constrain(EdgeRef(id, corner));
    fresh.push_back({slot.to(corner), slot.from(corner)});
  }
  return fresh;
}

/// The kept triangles, ordered by their least vertex: vertices are numbered along a space-filling curve,
/// so triangles that are near in the plane become near in memory.
std::vector<TriangleId> kept_in_order(const Triangulation& t, const Array<Index>& label, Index removed) {
  const auto least = [&](TriangleId id) { return std::min({t.slots[id].v[0], t.slots[id].v[1], t.slots[id].v[2]}); };
  std::vector<Index> start(t.points.size() + 1, 0);
  for (TriangleId id = 0; id < t.slots.size(); ++id)
    if (label[id] != removed) ++start[least(id) + 1U];
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
  std::vector<TriangleId> order(start.back());
  for (TriangleId id = 0; id < t.slots.size(); ++id)
    if (label[id] != removed) order[start[least(id)]++] = id;
  return order;
}

}  // namespace

std::vector<Constraint> carve(Triangulation& t, const DomainRules& rules) {
  std::vector<Constraint> hull;
  if (rules.convex_hull) hull = constrain_hull(t);

  constexpr Index unlabelled = no_index, removed = no_index - 1;
  Array<Index> label(t.slots.size(), unlabelled);
  std::vector<TriangleId> stack;
  TriangleId inside = no_index;
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    if (t.slots[id].is_ghost())
      stack.push_back(id);
    else
      inside = id;
  }
  for (const Point hole : rules.holes) stack.push_back(locate(t, hole, inside));
  flood(t, stack, label, removed);
  for (std::size_t r = 0; r < rules.region_seeds.size(); ++r) {
    const TriangleId seed = locate(t, rules.region_seeds[r], inside);
    if (label[seed] == removed) continue;
    stack.push_back(seed);
    flood(t, stack, label, static_cast<Index>(r));
  }

  const std::vector<TriangleId> order = kept_in_order(t, label, removed);
  Array<Index> number(t.slots.size(), no_index);
  for (std::size_t k = 0; k < order.size(); ++k) number[order[k]] = static_cast<Index>(k);
  Array<Slot> kept;
  kept.reserve(order.size());
  for (const TriangleId id : order) {
    Slot slot = t.slots[id];
    for (EdgeRef& out : slot.n)
      out = number[out.triangle()] == no_index ? EdgeRef()
                                               : EdgeRef(number[out.triangle()], out.side(), out.constrained());
    kept.push_back(slot);
  }
  if (!rules.region_seeds.empty()) {
    t.region.clear();
    t.region.reserve(order.size());
    for (const TriangleId id : order) t.region.push_back(label[id]);
  }
  t.slots = std::move(kept);
  return hull;
}

}  // namespace pardel
