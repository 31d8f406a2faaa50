#include "carve.hpp"

#include <cassert>

#include "../threads/parallel_arrays.hpp"
#include "../triangulation/locate.hpp"
#include "flood.hpp"
#include "remove_triangles.hpp"

namespace pardel::engine {
namespace {

/// Constrains the edges of the convex hull and returns those that were not constrained before.
std::vector<Constraint> constrain_hull(Triangulation& t, std::span<const TriangleId> ghosts, SparseAsk& ask) {
  std::vector<Constraint> fresh;
  for (const TriangleId id : ghosts) {
    ask();
    const Slot slot = t.slots[id];
    const unsigned corner = slot.corner_of(ghost);
    if (slot.n[corner].constrained()) continue;
    t.constrain(EdgeRef(id, corner));
    fresh.push_back({slot.to(corner), slot.from(corner)});
  }
  return fresh;
}

}  // namespace

std::vector<Constraint> carve(Triangulation& t, const DomainRules& rules, const Threads& threads,
                              const std::function<void(std::span<const TriangleId>)>& look_at_outside) {
  const std::size_t n = t.slots.size();
  const Array<TriangleId> ghosts = indices_where(threads, n, [&](std::size_t id) { return t.slots[id].is_ghost(); });
  SparseAsk ask(threads.stop);
  std::vector<Constraint> hull;
  if (rules.convex_hull) hull = constrain_hull(t, ghosts.span(), ask);
  if (rules.convex_hull && rules.holes.empty() && rules.region_seeds.empty()) {
    // The constrained hull separates the ghosts from all other triangles.
    remove_triangles(
        t, ghosts.span(), [&](TriangleId id) { return t.slots[id].is_ghost(); }, [](auto, auto) {}, ask);
    return hull;
  }

  constexpr Index unlabelled = no_index, removed = no_index - 1;
  Array<Index> label = make_array(threads, n, [](std::size_t) { return unlabelled; });
  assert(ghosts.size() < n);
  auto inside = static_cast<TriangleId>(n - 1);
  while (t.slots[inside].is_ghost()) --inside;
  std::vector<TriangleId> stack(ghosts.begin(), ghosts.end());
  for (const Point hole : rules.holes) {
    threads.ask();  // a walk through a large triangulation takes long
    stack.push_back(locate(t, hole, inside));
  }
  flood(t, stack, label, removed, ask);
  for (std::size_t r = 0; r < rules.region_seeds.size(); ++r) {
    threads.ask();
    const TriangleId seed = locate(t, rules.region_seeds[r], inside);
    if (label[seed] == removed) continue;
    stack.push_back(seed);
    flood(t, stack, label, static_cast<Index>(r), ask);
  }

  const Array<TriangleId> outside = indices_where(threads, n, [&](std::size_t id) { return label[id] == removed; });
  look_at_outside(outside.span());
  remove_triangles(
      t, outside.span(), [&](TriangleId id) { return label[id] == removed; },
      [&](TriangleId from, TriangleId to) { label[to] = label[from]; }, ask);
  if (rules.region_seeds.empty()) return hull;
  label.resize(t.slots.size());
  t.region = std::move(label);
  return hull;
}

}  // namespace pardel::engine
