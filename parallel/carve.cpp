#include "../core/mutants.hpp"
#include "constrain.hpp"
#include "locate.hpp"

namespace pardel {
namespace {

/// Marks what can be reached from the triangles on the stack without crossing a constrained edge.
void flood(const Triangulation& t, std::vector<TriangleId>& stack, Array<Index>& label, Index value) {
  while (!stack.empty()) {
    const TriangleId id = stack.back();
    stack.pop_back();
    if (label[id] == value) continue;
    label[id] = value;
    if (value < t.slots.size() && mutated("region_does_not_spread")) continue;
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
    if (slot.n[corner].constrained() || (fresh.size() == 1 && mutated("hull_edge_not_constrained"))) continue;
    t.constrain(EdgeRef(id, corner));
    fresh.push_back({slot.to(corner), slot.from(corner)});
  }
  return fresh;
}

/// Takes the triangles so labelled out, by moving the last ones that stay into their places: those that stay
/// keep their order, which follows a space-filling curve, but for as many as go.
void remove_labelled(Triangulation& t, Array<Index>& label, Index removed) {
  std::vector<TriangleId> holes;
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    if (label[id] != removed) continue;
    holes.push_back(id);
    for (const EdgeRef out : t.slots[id].n)
      if (label[out.triangle()] != removed) t.slots[out.triangle()].n[out.side()] = EdgeRef();
  }
  const std::size_t kept = t.slots.size() - holes.size();
  auto last = static_cast<TriangleId>(t.slots.size());
  for (const TriangleId hole : holes) {
    if (hole >= kept) break;
    do --last;
    while (label[last] == removed);
    t.move_triangle(last, hole);
    label[hole] = label[last];
  }
  t.slots.resize(kept);
  label.resize(kept);
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
  for (const Point hole : rules.holes)
    if (!mutated("hole_not_carved")) stack.push_back(locate(t, hole, inside));
  flood(t, stack, label, removed);
  for (std::size_t r = 0; r < rules.region_seeds.size(); ++r) {
    const TriangleId seed = locate(t, rules.region_seeds[r], inside);
    if (label[seed] == removed) continue;
    stack.push_back(seed);
    flood(t, stack, label, static_cast<Index>(r));
  }

  remove_labelled(t, label, removed);
  if (!rules.region_seeds.empty()) t.region = std::move(label);
  return hull;
}

}  // namespace pardel
