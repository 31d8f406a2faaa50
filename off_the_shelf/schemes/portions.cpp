#include "portions.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "../../parallel/decomposition/bounding_box.hpp"
#include "../../parallel/decomposition/quadtree.hpp"
#include "../../parallel/scheduling/initial_assessment.hpp"
#include "../../parallel/threads/parallel_for.hpp"
#include "../../parallel/triangulation/triangle_shape.hpp"

namespace pardel::engine {
namespace {

Point centroid(const Triangulation& t, TriangleId id) {
  const auto& v = t.slots[id].v;
  return centroid_of(t.points[v[0]], t.points[v[1]], t.points[v[2]]);
}

/// A quadtree whose leaves have at most `most` of the work, and the leaf of each place.
struct Leaves {
  Quadtree tree;
  std::vector<Index> leaf_of;
};
Leaves leaves_for(const Box& square, std::span<const Point> places, std::span<const double> work, double most,
                  const Threads& threads) {
  Leaves leaves{Quadtree(square), std::vector<Index>(places.size(), 0)};
  for (unsigned depth = 0; depth < Square::deepest; ++depth) {
    std::vector<double> per_leaf(leaves.tree.cells(), 0);
    for (std::size_t i = 0; i < places.size(); ++i) per_leaf[leaves.leaf_of[i]] += work[i];
    // A leaf with one triangle stays: a triangle is not divided.
    std::vector<Index> count(leaves.tree.cells(), 0);
    for (const Index leaf : leaves.leaf_of) ++count[leaf];
    for (std::size_t leaf = 0; leaf < count.size(); ++leaf)
      if (count[leaf] < 2) per_leaf[leaf] = 0;
    if (std::ranges::all_of(per_leaf, [&](double sum) { return sum <= most; })) break;
    leaves.tree = leaves.tree.divided(per_leaf, most);
    parallel_blocks(threads, places.size(), [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t i = first; i < last; ++i) leaves.leaf_of[i] = leaves.tree.cell_of(places[i]);
    });
  }
  return leaves;
}

}  // namespace

Box bounds_of(const Triangulation& t, const Threads& threads) {
  return bounding_box(threads, 3 * t.slots.size(), [&](std::size_t i) { return t.points[t.slots[i / 3].v[i % 3]]; });
}

ToSplit triangles_to_split(const MesherRun& run) {
  const Triangulation& t = run.mesh.t;
  const InitialAssessment found = assess_all(t, run.criteria, run.mesh.assessor, run.threads);
  ToSplit result;
  result.triangles.reserve(found.bad.size());
  for (const Deferred& bad : found.bad) result.triangles.push_back(bad.triangle.id());
  result.work.assign(found.bad.size(), run.criteria.triangles_by_shape());
  if (!run.criteria.has_size()) return result;
  parallel_blocks(run.threads, result.triangles.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    LocalHints hints;
    for (std::size_t i = first; i < last; ++i) {
      const TriangleId id = result.triangles[i];
      result.work[i] += run.criteria.triangles_wanted(Shape(t, t.slots[id]), run.mesh.assessor.region_of(id), hints);
    }
  });
  return result;
}

void repeat_sweeps(MesherRun& run, double largest_share_left,
                   const std::function<void(const ToSplit&, unsigned)>& sweep) {
  double before = INFINITY;
  bool may_retry = true;
  for (unsigned number = 0; number < run.how.most_sweeps; ++number) {
    run.threads.ask();
    const ToSplit to_split = triangles_to_split(run);
    const double left = std::accumulate(to_split.work.begin(), to_split.work.end(), 0.0);
    if (to_split.triangles.empty()) return;
    if (left > largest_share_left * before) {
      // After breaches, the same work is tried once more, in other parts.
      if (run.report.breaches.total() == 0 || !std::exchange(may_retry, false)) return;
    }
    before = left;
    ++run.report.sweeps;
    sweep(to_split, number);
  }
}

std::vector<TriangleId> all_triangles(const Triangulation& t) {
  std::vector<TriangleId> all(t.slots.size());
  std::iota(all.begin(), all.end(), TriangleId{0});
  return all;
}

std::vector<TriangleId> with_rings(const Triangulation& t, std::span<const TriangleId> triangles, int rings) {
  std::vector<char> is_in(t.slots.size(), 0);
  std::vector<TriangleId> found(triangles.begin(), triangles.end());
  for (const TriangleId id : found) is_in[id] = 1;
  std::size_t first = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const std::size_t end = found.size();
    for (; first < end; ++first)
      for (const EdgeRef out : t.slots[found[first]].n)
        if (!out.none() && is_in[out.triangle()] == 0) {
          is_in[out.triangle()] = 1;
          found.push_back(out.triangle());
        }
  }
  std::ranges::sort(found);
  return found;
}

Portions divide_among_leaves(const MesherRun& run, std::span<const TriangleId> triangles, const ToSplit& to_split,
                             unsigned shift) {
  const Triangulation& t = run.mesh.t;
  const Box bounds = bounds_of(t, run.threads);
  const double extent = bounds.extent(), moved = shift * extent;
  const Box square{bounds.min_x - moved, bounds.min_y - moved, bounds.min_x - moved + 3 * extent,
                   bounds.min_y - moved + 3 * extent};
  std::vector<Point> places(triangles.size());
  std::vector<double> work(triangles.size(), 1);  // a triangle that stays has to be copied
  std::vector<std::size_t> place_of(to_split.triangles.size());
  for (std::size_t i = 0, next = 0; i < triangles.size(); ++i) {
    places[i] = centroid(t, triangles[i]);
    if (next == place_of.size() || to_split.triangles[next] != triangles[i]) continue;
    work[i] = to_split.work[next];
    place_of[next++] = i;
  }
  const Leaves leaves = leaves_for(square, places, work, run.how.triangles_per_task, run.threads);

  Portions portions;
  portions.portion_of.assign(t.slots.size(), no_index);
  std::vector<Index> portion_of_leaf(leaves.tree.cells(), no_index);
  for (const std::size_t i : place_of) portion_of_leaf[leaves.leaf_of[i]] = 0;
  Index count = 0;
  for (Index& portion : portion_of_leaf)
    if (portion != no_index) portion = count++;
  portions.all.resize(count);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Index portion = portion_of_leaf[leaves.leaf_of[i]];
    if (portion == no_index) continue;
    portions.portion_of[triangles[i]] = portion;
    portions.all[portion].triangles.push_back(triangles[i]);
  }
  return portions;
}

}  // namespace pardel::engine
