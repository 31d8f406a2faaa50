#include "pending_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "../quality/parts.hpp"
#include "../threads/parallel_arrays.hpp"
#include "../threads/parallel_for.hpp"
#include "take_due.hpp"

namespace pardel::engine {

void PendingTriangles::defer_all_of(const std::vector<PlannedTask>& tasks) {
  std::vector<std::span<const Deferred>> lists;
  lists.reserve(tasks.size());
  for (const PlannedTask& task : tasks) lists.emplace_back(task.result.deferred);
  append_blocks(threads_, lists, deferred_);
}

void PendingTriangles::set_aside(const Deferral& later) {
  set_aside_ = std::exchange(deferred_, {});
  deferred_ = take_due(threads_, set_aside_, later, [](const Deferred& d) { return d; });
}

void PendingTriangles::bring_back() {
  append_blocks(threads_, std::vector{deferred_.span()}, set_aside_);
  deferred_ = std::exchange(set_aside_, {});
}

std::vector<std::uint64_t> PendingTriangles::count_keys() const {
  std::vector<std::uint64_t> count(BucketQueue::last + 1, 0);
  SparseAsk ask(threads_.stop);
  for (const Deferred& d : deferred_) {
    ask();
    ++count[d.key];
  }
  return count;
}

unsigned PendingTriangles::median_key(std::span<const std::uint64_t> counts) {
  const std::uint64_t half = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}) / 2;
  unsigned key = 0;
  for (std::uint64_t up_to = counts[0]; up_to <= half && key < BucketQueue::last;) up_to += counts[++key];
  return key;
}

std::vector<unsigned> PendingTriangles::median_keys(const Tiles& tiles) const {
  std::vector<std::vector<std::uint16_t>> keys(tiles.cells());
  SparseAsk ask(threads_.stop);
  for (const Deferred& d : deferred_) {
    ask();
    if (d.triangle.is_current(t_)) keys[tiles.cell_of(t_.points[t_.slots[d.triangle.id()].v[0]])].push_back(d.key);
  }
  std::vector<unsigned> median;
  for (std::vector<std::uint16_t>& of_cell : keys) {
    const auto middle = of_cell.begin() + static_cast<std::ptrdiff_t>(of_cell.size() / 2);
    std::nth_element(of_cell.begin(), middle, of_cell.end());
    median.push_back(of_cell.empty() ? BucketQueue::last : *middle);
  }
  return median;
}

Array<WorkAt> PendingTriangles::work(const Criteria& criteria) const {
  // The least number of triangles by which a bad triangle is replaced.
  constexpr double least = 2;
  const int divisions = divisions_for(criteria, deferred_.size());
  const double least_of_part = std::ldexp(least, -2 * divisions);
  std::vector<std::vector<WorkAt>> found(block_count(deferred_.size()));
  parallel_blocks(threads_, deferred_.size(), [&](std::size_t first, std::size_t last, std::size_t block) {
    LocalHints hints;
    for (std::size_t i = first; i < last; ++i) {
      const QueuedTriangle triangle = deferred_[i].triangle;
      if (!triangle.is_current(t_)) continue;
      const Shape shape(t_, t_.slots[triangle.id()]);
      visit_parts(shape, divisions, [&](const Shape& part) {
        const double wanted = criteria.triangles_wanted(part, assessor_.region_of(triangle.id()), hints);
        found[block].push_back({part.centroid(), std::max(least_of_part, wanted)});
      });
    }
  });
  Array<WorkAt> all;
  append_blocks(threads_, found, all);
  return all;
}

SeedsByCell PendingTriangles::take_due_by_cell(const Tiles& tiles, const Deferrals& later) {
  const Array<QueuedTriangle> due =
      take_due(threads_, deferred_, later.weakest(), [](const Deferred& d) { return d.triangle; });
  return by_cell(tiles, due.span(), later);
}

SeedsByCell PendingTriangles::take_needing_larger_box_by_cell(const Tiles& tiles) {
  return by_cell(tiles, std::exchange(needs_larger_box_, {}), {});
}

SeedsByCell PendingTriangles::by_cell(const Tiles& tiles, std::span<const QueuedTriangle> triangles,
                                      const Deferrals& later) {
  Array<Index> cell;  // no_index: the triangle needs no work on this lattice
  cell.resize_uninitialised(triangles.size());
  std::vector<std::vector<Deferred>> deferred(block_count(triangles.size()));
  parallel_blocks(threads_, triangles.size(), [&](std::size_t first, std::size_t last, std::size_t block) {
    LocalHints hints;
    for (std::size_t i = first; i < last; ++i) {
      cell[i] = no_index;
      if (!triangles[i].is_current(t_)) continue;
      const TriangleId id = triangles[i].id();
      const Shape shape(t_, t_.slots[id]);
      const Assessment a = assessor_.assess(id, shape, hints);
      if (a.need == Assessment::Need::nothing) continue;
      const bool skip = later.same_everywhere() && later.of(0).defers(a, shape);
      const Index to = skip ? 0 : tiles.cell_of(assessor_.point_for(id, a, hints));
      if (skip || later.of(to).defers(a, shape))
        deferred[block].push_back({triangles[i], a});
      else
        cell[i] = to;
    }
  });
  append_blocks(threads_, deferred, deferred_);
  SeedsByCell seeds(tiles.cells());
  visit_by_cell(threads_, cell.span(), tiles.cells(),
                [&](Index to, std::size_t i) { seeds[to].push_back(triangles[i]); });
  return seeds;
}

}  // namespace pardel::engine
