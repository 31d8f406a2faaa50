// The bad triangles that wait for a later pass, and their distribution to the cells of the tiles.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "../../core/array.hpp"
#include "../decomposition/tiles.hpp"
#include "../refinement/deferral.hpp"
#include "phase.hpp"
#include "waiting.hpp"

namespace pardel::engine {

/// The centroid of a triangle, and the estimated number of triangles by which it will be replaced.
struct WorkAt {
  Point place;
  double triangles;
};

/// Holds two lists: deferred triangles, which a later pass processes, and triangles that wait for the way back to
/// coarser tiles, because their cavities need a larger box or because they were blocked (TaskResult::blocked). Entries
/// may be stale (refinement/queued_triangle.hpp).
class PendingTriangles {
 public:
  PendingTriangles(const Triangulation& t, const Assessor& assessor, const Threads& threads)
      : t_(t), assessor_(assessor), threads_(threads) {}

  /// From now on, these threads work.
  void use(const Threads& threads) { threads_ = threads; }
  void defer(Array<Deferred> triangles) { deferred_ = std::move(triangles); }
  /// Adds triangles to both lists.
  void add(const Waiting& waiting) {
    deferred_.append(waiting.deferred);
    add_needing_larger_box(waiting.needing_larger_box);
  }
  /// The triangles of both lists, which are empty afterwards.
  [[nodiscard]] Waiting take() {
    const Array<Deferred> deferred = std::exchange(deferred_, {});
    return {{deferred.begin(), deferred.end()}, take_needing_larger_box()};
  }
  /// Adds the triangles that the tasks have deferred, in the order of the tasks.
  void defer_all_of(const std::vector<PlannedTask>& tasks);
  void add_needing_larger_box(std::span<const QueuedTriangle> triangles) {
    needs_larger_box_.insert(needs_larger_box_.end(), triangles.begin(), triangles.end());
  }
  [[nodiscard]] bool any_needs_larger_box() const { return !needs_larger_box_.empty(); }
  [[nodiscard]] std::vector<QueuedTriangle> take_needing_larger_box() { return std::exchange(needs_larger_box_, {}); }
  /// Keeps, of both lists, the triangles that still exist and for which keep(id) is true.
  template <class Keep>
  void keep_if(const Keep& keep);

  /// Takes all triangles that `later` defers by their keys out of the list, until bring_back(). The passes in between
  /// then do not examine them.
  void set_aside(const Deferral& later);
  void bring_back();

  /// The numbers of deferred triangles with each key, stale ones included.
  [[nodiscard]] std::vector<std::uint64_t> count_keys() const;
  /// The median of the keys, given their numbers.
  [[nodiscard]] static unsigned median_key(std::span<const std::uint64_t> counts);
  /// For each cell, the median of the keys of the deferred triangles whose first corners lie in the cell.
  [[nodiscard]] std::vector<unsigned> median_keys(const Tiles& tiles) const;
  /// The work at each deferred triangle.
  [[nodiscard]] Array<WorkAt> work(const Criteria& criteria) const;

  /// Takes the deferred triangles that are due. Puts each into the list of the cell in which its split point lies.
  /// Defers a triangle again if `later` says so.
  [[nodiscard]] SeedsByCell take_due_by_cell(const Tiles& tiles, const Deferrals& later);
  /// The same for the triangles that need a larger box. No triangle is deferred.
  [[nodiscard]] SeedsByCell take_needing_larger_box_by_cell(const Tiles& tiles);

 private:
  [[nodiscard]] SeedsByCell by_cell(const Tiles& tiles, std::span<const QueuedTriangle> triangles,
                                    const Deferrals& later);

  const Triangulation& t_;
  const Assessor& assessor_;
  Threads threads_;
  Array<Deferred> deferred_, set_aside_;
  std::vector<QueuedTriangle> needs_larger_box_;
};

template <class Keep>
void PendingTriangles::keep_if(const Keep& keep) {
  const auto stays = [&](QueuedTriangle triangle) { return triangle.is_current(t_) && keep(triangle.id()); };
  Array<Deferred> kept;
  for (const Deferred& d : deferred_)
    if (stays(d.triangle)) kept.push_back(d);
  deferred_ = std::move(kept);
  std::erase_if(needs_larger_box_, [&](QueuedTriangle triangle) { return !stays(triangle); });
}

}  // namespace pardel::engine
