#include "cut_out.hpp"

#include <vector>

#include "../construction/flood.hpp"
#include "../construction/remove_triangles.hpp"
#include "../threads/parallel_arrays.hpp"

namespace pardel::engine {
namespace {

/// Constrains the edges of the borders. Returns the triangles on their left: one for each edge that was found.
std::vector<TriangleId> constrain_borders(Triangulation& t, const BorderEdges& edges, SparseAsk& ask) {
  std::vector<TriangleId> beside;
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    ask();
    for (unsigned side = 0; side < 3; ++side) {
      if (edges.find(t.slots[id].from(side), t.slots[id].to(side)) == nullptr) continue;
      t.constrain(EdgeRef(id, side));
      beside.push_back(id);
    }
  }
  return beside;
}

}  // namespace

bool cut_out(Triangulation& t, std::span<const VertexId> border, const BorderEdges& edges, const Threads& threads) {
  for (const VertexId v : border) t.origin[v] = border_vertex;
  SparseAsk ask(threads.stop);
  std::vector<TriangleId> beside = constrain_borders(t, edges, ask);
  if (beside.size() != edges.all().size()) return false;
  constexpr Index kept = 0, removed = 1;
  const std::size_t n = t.slots.size();
  Array<Index> label(n, kept);
  flood(t, beside, label, removed, ask);
  const Array<TriangleId> inside = indices_where(threads, n, [&](std::size_t id) { return label[id] == removed; });
  remove_triangles(
      t, inside.span(), [&](TriangleId id) { return label[id] == removed; },
      [&](TriangleId from, TriangleId to) {
        label[to] = kept;
        if (!t.region.empty()) t.region[to] = t.region[from];
      },
      ask);
  if (!t.region.empty()) t.region.resize(t.slots.size());
  return true;
}

}  // namespace pardel::engine
