#include "portions.hpp"

#include <algorithm>
#include <numeric>

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

/// About how many triangles will replace each of the triangles.
std::vector<double> work_of(const MesherRun& run, std::span<const TriangleId> triangles,
                            std::span<const TriangleId> to_split) {
  const Triangulation& t = run.mesh.t;
  std::vector<double> work(triangles.size(), 1);
  parallel_blocks(run.threads, triangles.size(), [&](std::size_t first, std::size_t last, std::size_t) {
    LocalHints hints;
    for (std::size_t i = first; i < last; ++i) {
      const TriangleId id = triangles[i];
      if (!std::ranges::binary_search(to_split, id)) continue;
      work[i] = run.criteria.triangles_by_shape();
      if (run.criteria.has_size())
        work[i] += run.criteria.triangles_wanted(Shape(t, t.slots[id]), run.mesh.assessor.region_of(id), hints);
    }
  });
  return work;
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

Box bounds_of(const Triangulation& t) {
  Box bounds = empty_box;
  for (const Slot& slot : t.slots)
    for (const VertexId v : slot.v) bounds.cover(Box::around(t.points[v]));
  return bounds;
}

std::vector<TriangleId> triangles_to_split(const MesherRun& run) {
  const InitialAssessment found = assess_all(run.mesh.t, run.criteria, run.mesh.assessor, run.threads);
  std::vector<TriangleId> triangles;
  triangles.reserve(found.bad.size());
  for (const Deferred& bad : found.bad) triangles.push_back(bad.triangle.id());
  return triangles;
}

double work_on(const MesherRun& run, std::span<const TriangleId> to_split) {
  const std::vector<double> work = work_of(run, to_split, to_split);
  return std::accumulate(work.begin(), work.end(), 0.0);
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

Portions divide_among_leaves(const MesherRun& run, std::span<const TriangleId> triangles,
                             std::span<const TriangleId> to_split, unsigned shift) {
  const Triangulation& t = run.mesh.t;
  const Box bounds = bounds_of(t);
  const double extent = bounds.extent(), moved = shift * extent;
  const Box square{bounds.min_x - moved, bounds.min_y - moved, bounds.min_x - moved + 3 * extent,
                   bounds.min_y - moved + 3 * extent};
  std::vector<Point> places(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) places[i] = centroid(t, triangles[i]);
  const Leaves leaves =
      leaves_for(square, places, work_of(run, triangles, to_split), run.how.triangles_per_task, run.threads);

  Portions portions;
  portions.portion_of.assign(t.slots.size(), no_index);
  std::vector<Index> portion_of_leaf(leaves.tree.cells(), no_index);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (std::ranges::binary_search(to_split, triangles[i])) portion_of_leaf[leaves.leaf_of[i]] = 0;
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
