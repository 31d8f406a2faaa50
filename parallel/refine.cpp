#include "refine.hpp"

#include <algorithm>
#include <cmath>

#include "task.hpp"

namespace pardel {
namespace {

/// The final triangles of one tile fit the second-level cache together with their vertices.
constexpr double triangles_per_tile = 16'000;
/// From one lattice to the next finer one, the side of a cell shrinks by this factor.
constexpr Index levels_apart = 4;
/// A level splits what is longer than this part of the next finer level's cell: shorter triangles have
/// cavities that fit that level's boxes.
constexpr double long_in_finer_cells = 0.25;

Box bounds_of(std::span<const Point> points) {
  Box box{INFINITY, INFINITY, -INFINITY, -INFINITY};
  for (const Point p : points) {
    box.min_x = std::min(box.min_x, p.x);
    box.min_y = std::min(box.min_y, p.y);
    box.max_x = std::max(box.max_x, p.x);
    box.max_y = std::max(box.max_y, p.y);
  }
  return box;
}

/// The lattices from one cell to the finest, coarse to fine.
std::vector<Lattice> lattices(Box bounds, double estimate) {
  const double width = bounds.max_x - bounds.min_x, height = bounds.max_y - bounds.min_y;
  const double tiles = std::max(1.0, estimate / triangles_per_tile);
  const double longer = std::max(width, height), shorter = std::max(std::min(width, height), longer * 1e-3);
  constexpr double most_along = 4096;
  auto along = static_cast<Index>(std::clamp(std::sqrt(tiles * longer / shorter), 1.0, most_along));
  std::vector<Lattice> result;
  while (along > 1) {
    result.push_back(Lattice::over(bounds, along));
    along = (along + levels_apart - 1) / levels_apart;
  }
  result.push_back(Lattice::over(bounds, 1));
  std::reverse(result.begin(), result.end());
  return result;
}

class Refinement {
 public:
  Refinement(Triangulation& t, const Lines& lines, const Criteria& criteria, const Options& options)
      : t_(t), judge_(t, lines, criteria, options), task_(t, lines, judge_, criteria, options) {}

  RefineCounts run(const Criteria& criteria) {
    double estimate = 0;
    for (TriangleId id = 0; id < t_.slots.size(); ++id) {
      estimate += std::max(1.7, criteria.triangles_wanted(Shape(t_, t_.slots[id]), judge_.region_of(id)));
      const Assessment a = judge_.assess(id);
      if (a.need != Assessment::Need::nothing) task_.deferred.push_back(id);
      task_.left_alone = task_.left_alone || a.left_alone;
    }
    const std::vector<Lattice> levels = lattices(bounds_of(t_.points.span()), estimate);

    // Down: what is long at a level is split there; what gets short enough waits for a finer one.
    for (std::size_t level = 0; level < levels.size() && go_on(); ++level) {
      if (level + 1 < levels.size()) {
        const double longest = long_in_finer_cells * levels[level + 1].side();
        sweep_to_fixpoint(levels[level], std::exchange(task_.deferred, {}), {longest * longest});
        continue;
      }
      // Everywhere the shorter half of the work comes before the longer: points put in for long triangles would
      // only be in the way of those that short ones need anyway. Tiles that finish one by one cannot have this
      // order by themselves, and neither has one queue over everything: it makes larger meshes.
      const Deferral longer_half{0, median_key(task_.deferred)};
      sweep_to_fixpoint(levels[level], std::exchange(task_.deferred, {}), longer_half);
      sweep_to_fixpoint(levels[level], std::exchange(task_.deferred, {}), {});
    }
    // Up: what no box of a level could hold gets a larger one.
    for (std::size_t level = levels.size() - 1; level-- > 0 && go_on();)
      sweep_to_fixpoint(levels[level], std::exchange(task_.stuck, {}), {});

    counts_.inserted = task_.inserted;
    counts_.segment_splits = task_.segment_splits;
    counts_.refused = task_.refused;
    counts_.budget_reached = task_.budget_reached;
    counts_.left_alone = task_.left_alone || !task_.stuck.empty();  // with a point that is nowhere
    return counts_;
  }
  [[nodiscard]] bool cancelled() const { return task_.cancelled; }

 private:
  [[nodiscard]] bool go_on() const { return !task_.cancelled && !task_.budget_reached; }

  [[nodiscard]] unsigned median_key(const std::vector<TriangleId>& ids) const {
    std::vector<unsigned> keys;
    keys.reserve(ids.size());
    for (const TriangleId id : ids) keys.push_back(judge_.assess(id).key);
    if (keys.empty()) return BucketQueue::last;
    const auto middle = keys.begin() + static_cast<std::ptrdiff_t>(keys.size() / 2);
    std::nth_element(keys.begin(), middle, keys.end());
    return *middle;
  }

  void sweep_to_fixpoint(const Lattice& lattice, const std::vector<TriangleId>& pending, const Deferral& later) {
    std::vector<std::vector<TriangleId>> inbox(lattice.cells());
    bool any = false;
    for (const TriangleId id : pending) {
      const Assessment a = judge_.assess(id);
      if (a.need == Assessment::Need::nothing) continue;
      if (later.applies_to(a)) {
        task_.deferred.push_back(id);
        continue;
      }
      inbox[lattice.cell_of(judge_.point_for(id, a))].push_back(id);
      any = true;
    }
    while (any && go_on()) any = sweep(lattice, inbox, later);
  }

  /// Four phases, one per colour. Returns whether any candidate was handed to another cell.
  bool sweep(const Lattice& lattice, std::vector<std::vector<TriangleId>>& inbox, const Deferral& later) {
    Sweep done{lattice.cells(), 0, 0};
    const std::uint64_t before = t_.points.size();
    for (unsigned colour = 0; colour < Lattice::colours; ++colour) {
      for (Index cell = 0; cell < lattice.cells(); ++cell) {
        if (lattice.colour_of(cell) != colour || inbox[cell].empty()) continue;
        const std::vector<TriangleId> seeds = admitted(lattice.box_of(cell), std::exchange(inbox[cell], {}));
        if (!task_.run(lattice, cell, seeds, later)) return false;
        done.handed_on += task_.handed_on.size();
        for (const HandedOn& h : task_.handed_on) inbox[h.cell].push_back(h.id);
      }
    }
    done.inserted = t_.points.size() - before;
    counts_.sweeps.push_back(done);
    return std::any_of(inbox.begin(), inbox.end(), [](const auto& box) { return !box.empty(); });
  }

  /// The seeds whose triangles lie in the box; the others need a larger one.
  std::vector<TriangleId> admitted(const Box& box, std::vector<TriangleId> seeds) {
    std::erase_if(seeds, [&](TriangleId id) {
      const auto& v = t_.slots[id].v;
      const bool fits = box.contains(t_.points[v[0]]) && box.contains(t_.points[v[1]]) && box.contains(t_.points[v[2]]);
      if (!fits) task_.stuck.push_back(id);
      return !fits;
    });
    return seeds;
  }

  Triangulation& t_;
  Judge judge_;
  Task task_;
  RefineCounts counts_;
};

}  // namespace

Result<RefineCounts> refine(Triangulation& t, const Lines& lines, const Criteria& criteria, const Options& options) {
  Refinement refinement(t, lines, criteria, options);
  RefineCounts counts = refinement.run(criteria);
  if (refinement.cancelled()) return Error{ErrorKind::cancelled, "the caller asked to stop"};
  return counts;
}

std::vector<Exemption> exemptions(Triangulation& t, const Lines& lines, const Criteria& criteria,
                                  const Options& options, bool budget_reached) {
  const Judge judge(t, lines, criteria, options);
  Insertion insertion(t, criteria, options.min_edge);
  const Box everywhere;
  const auto why = [&](TriangleId id) -> Exemption {
    const Slot& slot = t.slots[id];
    const Shape shape(t, slot);
    const bool large = judge.too_large(id);
    if (!large)
      if (const auto small = small_angle(t, lines, slot, shape))
        return {id, small->reason, small->apex, small->angle_deg};
    if (budget_reached) return {id, ExemptReason::budget};
    if (shape.shortest_squared() < options.min_edge * options.min_edge) return {id, ExemptReason::min_edge};
    Outcome outcome = insertion.try_in_face(criteria.split_point(shape), id, everywhere);
    if (outcome == Outcome::encroaches) {
      const EdgeRef blocker = insertion.blocker();
      if (judge.forbidden(blocker)) return {id, ExemptReason::kept_segment};
      outcome = insertion.try_on_edge(judge.point_on(blocker), blocker, everywhere);
    }
    return {id, outcome == Outcome::too_close ? ExemptReason::min_edge : ExemptReason::precision};
  };
  std::vector<Exemption> result;
  for (TriangleId id = 0; id < t.slots.size(); ++id)
    if (judge.breaks_goal(id)) result.push_back(why(id));
  return result;
}

}  // namespace pardel
