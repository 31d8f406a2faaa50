#include "find_patches.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "../arithmetic/predicates.hpp"
#include "../decomposition/bounding_box.hpp"
#include "../threads/parallel_arrays.hpp"

namespace pardel::engine {
namespace {

/// The coordinates are at most so many edges. So a rounding moves a point by less than 1e-7 edges.
constexpr double most_edges = 0x1p26;

/// A coordinate of the lattice that is neither 0 nor a coordinate of the input is at least 2^-54 edges. With longer
/// edges, the predicates are exact for all of them.
constexpr double least_edge = smallest_coordinate * 0x1p54;

/// The triangles of each region; those without a region come last.
std::vector<std::vector<TriangleId>> by_region(const Triangulation& t, std::size_t regions, SparseAsk& ask) {
  std::vector<std::vector<TriangleId>> result(regions + 1);
  for (TriangleId id = 0; id < t.slots.size(); ++id) {
    ask();
    const Index region = t.region.empty() ? no_index : t.region[id];
    result[region == no_index ? regions : region].push_back(id);
  }
  return result;
}

/// Calls add(i, list) for all i < n, and returns all that was added to the lists.
template <class T, class Add>
std::vector<T> list_of(std::size_t n, const Threads& threads, const Add& add) {
  std::vector<std::vector<T>> blocks(block_count(n));
  parallel_blocks(threads, n, [&](std::size_t first, std::size_t last, std::size_t block) {
    SparseAsk ask(threads.stop);
    for (std::size_t i = first; i < last; ++i) {
      ask();
      add(i, blocks[block]);
    }
  });
  std::vector<T> all;
  for (const std::vector<T>& list : blocks) all.insert(all.end(), list.begin(), list.end());
  return all;
}

Patch patch_of(const Triangulation& t, std::span<const TriangleId> triangles, double edge,
               std::span<const Clearing> clearings, const Threads& threads) {
  const auto corner = [&](std::size_t i, unsigned k) { return t.points[t.slots[triangles[i]].v[k]]; };
  const Box box = bounding_box(threads, 3 * triangles.size(),
                               [&](std::size_t i) { return corner(i / 3, static_cast<unsigned>(i % 3)); });
  const TriangularLattice lattice({box.min_x, box.min_y}, edge,
                                  {box.min_x - edge, box.min_y - edge, box.max_x + edge, box.max_y + edge});
  const double farthest =
      std::max({std::abs(box.min_x), std::abs(box.max_x), std::abs(box.min_y), std::abs(box.max_y)});
  if (!(farthest < most_edges * edge) || edge < least_edge) return Patch(lattice, {});

  const auto is_boundary = [&](EdgeRef across) {
    return across.none() || (!t.region.empty() && t.region[across.triangle()] != t.region[triangles.front()]);
  };
  auto crossings = list_of<Crossing>(triangles.size(), threads, [&](std::size_t i, std::vector<Crossing>& list) {
    for (unsigned side = 0; side < 3; ++side)
      if (is_boundary(t.slots[triangles[i]].n[side]))
        lattice.add_crossings(corner(i, next_corner[side]), corner(i, previous_corner[side]), list);
  });
  const double distance = patch_clearance * edge;
  auto near = list_of<Span>(triangles.size(), threads, [&](std::size_t i, std::vector<Span>& spans) {
    const Slot& slot = t.slots[triangles[i]];
    for (unsigned side = 0; side < 3; ++side) {
      const Point from = t.points[slot.from(side)], to = t.points[slot.to(side)];
      // A vertex without segments is near, too. Each vertex is the start of a side of each of its triangles.
      lattice.add_near(from, slot.n[side].constrained() ? to : from, distance, spans);
    }
  });
  for (const Clearing& c : clearings) lattice.add_near(c.centre, c.centre, c.radius, near);
  return Patch(lattice, without(lattice.inside(std::move(crossings)), merged(std::move(near))));
}

}  // namespace

std::vector<RegionPatch> find_patches(const Triangulation& t, std::span<const double> edges,
                                      std::span<const Clearing> clearings, const Threads& threads) {
  SparseAsk ask(threads.stop);
  const std::size_t regions = edges.size() - 1;
  const std::vector<std::vector<TriangleId>> triangles = by_region(t, regions, ask);
  std::vector<RegionPatch> result;
  for (std::size_t r = 0; r <= regions; ++r) {
    if (triangles[r].empty() || !(edges[r] < INFINITY)) continue;
    Patch patch = patch_of(t, triangles[r], edges[r], clearings, threads);
    if (patch.triangles() == 0) continue;
    result.push_back({r < regions ? static_cast<Index>(r) : no_index, std::move(patch)});
  }
  return result;
}

}  // namespace pardel::engine
