#include "pending_triangles.hpp"

#include <utility>

#include "../concurrency/parallel_arrays.hpp"
#include "../concurrency/parallel_for.hpp"
#include "take_due.hpp"

namespace pardel::engine {

void PendingTriangles::defer_all_of(const std::vector<PlannedTask>& tasks) {
  std::vector<std::span<const Deferred>> lists;
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

unsigned PendingTriangles::median_key() const {
  std::vector<std::size_t> count(BucketQueue::last + 1, 0);
  SparseAsk ask(threads_.stop);
  for (const Deferred& d : deferred_) {
    ask();
    ++count[d.key];
  }
  unsigned key = 0;
  for (std::size_t up_to = count[0]; up_to <= deferred_.size() / 2 && key < BucketQueue::last;) up_to += count[++key];
  return key;
}

SeedsByCell PendingTriangles::take_due_by_cell(const Lattice& lattice, const Deferral& later) {
  const Array<QueuedTriangle> due = take_due(threads_, deferred_, later, [](const Deferred& d) { return d.triangle; });
  return by_cell(lattice, due.span(), later);
}

SeedsByCell PendingTriangles::take_needing_larger_box_by_cell(const Lattice& lattice) {
  return by_cell(lattice, std::exchange(needs_larger_box_, {}), {});
}

SeedsByCell PendingTriangles::by_cell(const Lattice& lattice, std::span<const QueuedTriangle> triangles,
                                      const Deferral& later) {
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
      if (later.defers(a, shape))
        deferred[block].push_back({triangles[i], a});
      else
        cell[i] = lattice.cell_of(assessor_.point_for(id, a, hints));
    }
  });
  append_blocks(threads_, deferred, deferred_);
  SeedsByCell seeds(lattice.cells());
  visit_by_cell(threads_, cell.span(), lattice.cells(),
                [&](Index to, std::size_t i) { seeds[to].push_back(triangles[i]); });
  return seeds;
}

}  // namespace pardel::engine
