#include "hairlines_outside.hpp"

#include <algorithm>
#include <utility>

#include "../../core/support/without_repetitions.hpp"
#include "delaunay.hpp"
#include "flood.hpp"
#include "insert_constraints.hpp"

namespace pardel::engine {
namespace {

/// A boundary edge, with the domain on its left.
using Side = std::pair<VertexId, VertexId>;

std::vector<Side> boundary_sides(const Triangulation& t, SparseAsk& ask) {
  std::vector<Side> sides;
  for (const Slot& slot : t.slots) {
    ask();
    for (unsigned side = 0; side < 3; ++side)
      if (slot.n[side].none()) sides.emplace_back(slot.from(side), slot.to(side));
  }
  std::ranges::sort(sides);
  return sides;
}

/// The constrained Delaunay triangulation of boundary edges.
struct Outlines {
  Triangulation triangulation;   ///< with ghosts
  std::vector<VertexId> vertex;  ///< of the mesh
};

Result<Outlines> triangulate(const std::vector<Side>& sides, const Array<Point>& points, const Threads& threads) {
  std::vector<VertexId> vertices;
  for (const auto& [from, to] : sides) vertices.insert(vertices.end(), {from, to});
  sort_without_repetitions(vertices);
  std::vector<Point> places;
  for (const VertexId v : vertices) places.push_back(points[v]);
  Result<Delaunay> delaunay_of_all = delaunay(places, threads);
  if (!delaunay_of_all) return delaunay_of_all.error();
  Outlines result{std::move(delaunay_of_all->triangulation), {}};
  std::vector<VertexId> local(vertices.size());  // of the vertices, in their order
  for (VertexId v = 0; v < local.size(); ++v) {
    const Index number = delaunay_of_all->input_of_vertex[v];
    local[number] = v;
    result.vertex.push_back(vertices[number]);
  }
  const auto local_of = [&](VertexId v) { return local[std::ranges::lower_bound(vertices, v) - vertices.begin()]; };
  std::vector<Constraint> constraints;
  for (const auto& [from, to] : sides) constraints.push_back({local_of(from), local_of(to)});
  if (Status inserted = insert_constraints(result.triangulation, constraints, threads); !inserted)
    return inserted.error();
  return result;
}

/// One triangle at each boundary edge on the side on which the domain is not.
std::vector<TriangleId> beside_boundary(const Outlines& outlines, const std::vector<Side>& sides) {
  std::vector<TriangleId> found;
  const Triangulation& t = outlines.triangulation;
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    const Slot& slot = t.slots[id];
    for (unsigned side = 0; side < 3; ++side)
      if (slot.n[side].constrained() &&
          std::ranges::binary_search(sides, Side(outlines.vertex[slot.to(side)], outlines.vertex[slot.from(side)])))
        found.push_back(id);
  }
  return found;
}

}  // namespace

std::vector<Hairline> hairlines_outside(const Triangulation& t, const Threads& threads) {
  SparseAsk ask(threads.stop);
  const std::vector<Side> sides = boundary_sides(t, ask);
  const Result<Outlines> outlines = triangulate(sides, t.points, threads);
  if (!outlines) return {};
  const Triangulation& all = outlines->triangulation;
  Array<Index> is_outside(all.slots.size(), 0);
  std::vector<TriangleId> stack = beside_boundary(*outlines, sides);
  flood(all, stack, is_outside, 1, ask);
  std::vector<FlatTriangle> flat;
  for (TriangleId id = 0; id < all.slots.size(); ++id)
    if (is_outside[id] != 0 && !all.slots[id].is_ghost())
      add_if_flat(
          all, all.slots[id], [&](VertexId v) { return outlines->vertex[v]; }, flat);
  return hairlines_among(flat);
}

}  // namespace pardel::engine
