#include "flips.hpp"

#include "in_circumdisk.hpp"

namespace pardel::engine {

void flip(Triangulation& t, EdgeRef e) {
  const unsigned i = e.side();
  const EdgeRef across = t.slot(e).n[i];
  const unsigned j = across.side();
  const Slot left = t.slot(e), right = t.slot(across);
  const VertexId p = left.v[i], a = left.from(i), b = left.to(i), q = right.v[j];
  const TriangleId l = e.triangle(), r = across.triangle();

  t.slots[l].v = {p, a, q};
  t.slots[r].v = {q, b, p};
  t.slots[l].n[1] = EdgeRef(r, 1);
  t.slots[r].n[1] = EdgeRef(l, 1);
  t.link(EdgeRef(l, 0), right.n[next_corner[j]]);
  t.link(EdgeRef(l, 2), left.n[previous_corner[i]]);
  t.link(EdgeRef(r, 0), left.n[next_corner[i]]);
  t.link(EdgeRef(r, 2), right.n[previous_corner[j]]);
}

bool locally_delaunay(const Triangulation& t, EdgeRef e) {
  return t.slot(e).n[e.side()].constrained() || delaunay_across(t, e);
}

bool delaunay_across(const Triangulation& t, EdgeRef e) {
  const Slot& slot = t.slot(e);
  const EdgeRef across = slot.n[e.side()];
  const VertexId q = t.slot(across).apex(across.side());
  return !in_circumdisk(t, slot, t.points[q]);
}

void restore_delaunay(Triangulation& t, std::vector<EdgeRef> suspects, std::vector<TriangleId>& changed,
                      const Threads& threads) {
  SparseAsk ask(threads.stop);
  while (!suspects.empty()) {
    ask();
    const EdgeRef e = suspects.back();
    suspects.pop_back();
    if (t.slot(e).is_ghost() || t.slot(e).n[e.side()].constrained()) continue;
    const EdgeRef across = t.slot(e).n[e.side()];
    if (t.slot(across).is_ghost() || locally_delaunay(t, e)) continue;
    flip(t, e);
    const TriangleId l = e.triangle(), r = across.triangle();
    changed.insert(changed.end(), {l, r});
    suspects.insert(suspects.end(), {EdgeRef(l, 0), EdgeRef(l, 2), EdgeRef(r, 0), EdgeRef(r, 2)});
  }
}

void make_delaunay(Triangulation& t, const Threads& threads) {
  SparseAsk ask(threads.stop);
  std::vector<EdgeRef> suspects;
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    ask();
    for (unsigned side = 0; side < 3; ++side)
      if (!locally_delaunay(t, EdgeRef(id, side))) suspects.push_back(EdgeRef(id, side));
  }
  std::vector<TriangleId> changed;
  restore_delaunay(t, std::move(suspects), changed, threads);
}

}  // namespace pardel::engine
