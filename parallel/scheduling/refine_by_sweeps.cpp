#include "refine_by_sweeps.hpp"

#include <array>
#include <utility>

#include "../concurrency/bounding_box.hpp"
#include "../concurrency/lattice_levels.hpp"
#include "../triangulation/compact.hpp"
#include "../triangulation/held.hpp"
#include "../triangulation/radii.hpp"
#include "communicator.hpp"
#include "initial_assessment.hpp"
#include "level_rules.hpp"
#include "limits.hpp"
#include "sweeper.hpp"

namespace pardel::engine {
namespace {

/// The decomposition is a quadtree if the work in a cell of a lattice exceeds the average by more than this factor. If
/// all work lies around a point where four cells of sixteen meet, the factor is 4.
constexpr double most_overload = 3;

/// Takes a refinement through the levels of a decomposition: which tiles they have, and what is split on each.
class Refinement {
 public:
  Refinement(const RefinementJob& job, Triangulation& t, const DomainSegments& segments, Communicator* communicator)
      : job_(job),
        t_(t),
        segments_(segments),
        communicator_(communicator),
        in_parts_(communicator == nullptr ? nullptr : communicator->in_parts()),
        sweeper_(job, t, segments, job.progress.threads()) {}

  Status run() {
    const Box bounds = bounds_of_all();
    sweeper_.expect_within(bounds);
    InitialAssessment initial = assess();
    sweeper_.counts().left_alone = initial.left_alone;
    sweeper_.pending().defer(std::move(initial.bad));
    const double whole = initial.estimates.lower_bound + static_cast<double>(job_.progress.triangles_aside());
    const double needed = communicator_ == nullptr ? whole : whole / communicator_->ranks();
    if (Status fits = check_size(needed, job_.options); !fits) return fits;
    const Lattice finest = finest_lattice(bounds, initial.estimates.without_angle_bound, job_.options);
    job_.progress.start(initial.estimates.with_angle_bound, sweeper_.runner().vertices().in_use(),
                        sweeper_.runner().triangles().in_use());

    if (prefers_quadtree(finest))
      refine_in_quadtree(bounds);
    else
      refine_in_lattice(bounds, finest);
    if (communicator_ == nullptr) {
      compact(t_, IndexMoves(sweeper_.runner().vertices()), IndexMoves(sweeper_.runner().triangles()),
              sweeper_.threads());
    } else {
      add_up_counts();
      communicator_->finish();
    }
    // A triangle is left over if its split point lies in no triangle, if it is blocked, or if the refinement ended
    // early.
    sweeper_.counts().left_alone = sweeper_.counts().left_alone || sweeper_.pending().any_needs_larger_box();
    sweeper_.counts().tiling = std::move(sweeper_.record()).take();
    return Done{};
  }

  [[nodiscard]] RefineCounts counts() && { return std::move(sweeper_.counts()); }

 private:
  [[nodiscard]] Box bounds_of_all() {
    const Box here = bounding_box(sweeper_.threads(), t_.points.size(), [&](std::size_t v) { return t_.points[v]; });
    return in_parts_ != nullptr ? in_parts_->bounds_of_all(here) : here;
  }

  [[nodiscard]] InitialAssessment assess() {
    if (in_parts_ == nullptr) return assess_all(t_, job_.criteria, sweeper_.assessor(), sweeper_.threads());
    in_parts_->begin(sweeper_.runner());
    InitialAssessment initial =
        assess_all(t_, job_.criteria, sweeper_.assessor(), sweeper_.threads(),
                   [&](TriangleId id) { return in_parts_->holds(id) && communicator_->is_at_home(id); });
    TriangleEstimates& e = initial.estimates;
    std::array sums{e.without_angle_bound, e.with_angle_bound, e.lower_bound};
    add_up_estimates(sums, *communicator_);
    e = {sums[0], sums[1], sums[2]};
    return initial;
  }

  [[nodiscard]] bool prefers_quadtree(const Lattice& finest) const {
    if (job_.options.decomposition == Decomposition::quadtree ||
        job_.options.decomposition == Decomposition::paper_quadtree)
      return true;
    const bool may = job_.options.decomposition == Decomposition::automatic && job_.options.cells[0] == 0;
    return may && job_.criteria.depends_on_place() && finest.cells() > 1 &&
           overload(t_, job_.criteria, sweeper_.assessor(), finest, sweeper_.threads()) > most_overload;
  }

  void refine_in_lattice(const Box& bounds, const Lattice& finest) {
    Levels levels;
    for (const Lattice& lattice : lattice_levels(bounds, finest)) levels.emplace_back(lattice);
    go_down(levels);
    lay_finest(bounds, levels);
    const Deferral shorter_half{.last_key = median_key()};
    sweeper_.pending().add(std::exchange(waiting_, {}));
    if (communicator_ != nullptr) divide(levels.back());
    refine_on_finest(levels.back(), shorter_half);
    go_up(levels);
  }

  /// Each level divides the leaves in which too much work waits. The work is estimated from the mesh that the level
  /// before has made.
  void refine_in_quadtree(const Box& bounds) {
    Levels levels;
    levels.emplace_back(Quadtree(bounds));
    for (;;) {
      const Tiles& present = levels.back();
      Quadtree finer = divided_by_work(*present.quadtree(), sweeper_.pending().work(job_.criteria), job_.options,
                                       sweeper_.runner().vertices().available());
      if (finer.cells() == present.cells()) break;
      sweeper_.refine_due(present, short_enough_for(*present.quadtree(), finer, job_.options.decomposition));
      if (sweeper_.counts().budget_reached) break;
      levels.emplace_back(std::move(finer));
    }
    sweeper_.record().set_finest(levels.back(), bounds,
                                 largest_radii(t_, sweeper_.runner().triangles(), sweeper_.threads()), sweeper_.made());
    std::vector<Deferral> shorter_half;
    for (const unsigned key : sweeper_.pending().median_keys(levels.back())) shorter_half.push_back({.last_key = key});
    if (communicator_ != nullptr) divide(levels.back());
    refine_on_finest(levels.back(), Deferrals(std::move(shorter_half)));
    go_up(levels);
  }

  /// Splits, on each level, the triangles that are too long for the next finer level. Triangles that are short enough
  /// wait for a finer level. Most triangles of a fine input are short from the start. They are taken out first, so that
  /// the coarse levels do not examine them. (With the paper's decomposition, levels compare circumradii instead of
  /// lengths, and no triangle is taken out.)
  void go_down(const Levels& levels) {
    sweeper_.pending().set_aside(short_enough_for(*levels.back().lattice(), job_.options.decomposition));
    if (in_parts_ != nullptr)
      go_down_in_submesh(levels);
    else
      sweeper_.refine_coarse_levels(levels);
    sweeper_.pending().bring_back();
  }

  /// Refines a gathered submesh as work(sweeper) does. Returns the changed triangles. On one thread: tasks on several
  /// would all write to the triangle that stands for those beyond the submesh.
  template <class Work>
  std::vector<TriangleId> refine_submesh(const Communicator::GatheredSubmesh& submesh, const Work& work) {
    const DomainSegments& segments = submesh.segments != nullptr ? *submesh.segments : segments_;
    Sweeper sweeper(job_, submesh.t, segments, Threads(1, sweeper_.threads().stop));
    sweeper.begin_submesh(submesh);
    work(sweeper);
    return sweeper.take_changed();
  }

  /// What waits afterwards is added to the pending triangles when the median of the keys is known: for the median, it
  /// counts on the rank that has refined.
  void go_down_in_submesh(const Levels& levels) {
    const Waiting due = sweeper_.pending().take();
    RefineCounts in_last_submesh;  // a submesh that was too small does not count
    waiting_ = in_parts_->refine_coarse(
        due.deferred, [&](const Communicator::GatheredSubmesh& submesh, std::vector<TriangleId>& changed) {
          Waiting waiting;
          changed = refine_submesh(submesh, [&](Sweeper& in_submesh) {
            in_submesh.defer_again(submesh.first);
            in_submesh.refine_coarse_levels(levels);
            in_last_submesh = in_submesh.counts();
            keys_in_submesh_ = in_submesh.pending().count_keys();
            waiting = in_submesh.pending().take();
          });
          return waiting;
        });
    sweeper_.counts().add(in_last_submesh);
  }

  [[nodiscard]] unsigned median_key() {
    std::vector<std::uint64_t> counts = sweeper_.pending().count_keys();
    for (std::size_t key = 0; key < keys_in_submesh_.size(); ++key) counts[key] += keys_in_submesh_[key];
    if (in_parts_ != nullptr) communicator_->add_up(counts);
    return PendingTriangles::median_key(counts);
  }

  /// Measures the circumradii. With the paper's decomposition, widens the cells of the finest lattice to the size that
  /// the largest circumradius demands.
  void lay_finest(const Box& bounds, Levels& levels) {
    Radii largest = largest_radii(t_, sweeper_.runner().triangles(), sweeper_.threads());
    if (in_parts_ != nullptr) {
      std::array of_all{largest.radius, largest.ratio, largest.area};
      in_parts_->take_largest(of_all);
      largest = {of_all[0], of_all[1], of_all[2]};
    }
    if (job_.options.decomposition == Decomposition::paper)
      levels.back() =
          Tiles(with_cells_at_least(Lattice::radii_per_side * largest.radius, bounds, *levels.back().lattice()));
    sweeper_.record().set_finest(levels.back(), bounds, largest, sweeper_.made());
  }

  /// Splits the shorter half of the triangles first, in all cells, then the longer half. The points that split short
  /// triangles also split many long ones. In the opposite order, the points for long triangles would be additional.
  /// Tiles that finish one after the other do not produce this order by themselves. A single queue for all triangles
  /// does not produce it either, and makes larger meshes.
  void refine_on_finest(const Tiles& finest, const Deferrals& longer_half) {
    sweeper_.refine_due(finest, longer_half);
    sweeper_.refine_due(finest, {});
  }

  /// From here on, each rank refines its own cells of the finest tiles. Each triangle that waits waits on one rank.
  void divide(const Tiles& finest) {
    if (in_parts_ != nullptr) return divide_anew(finest);
    // A cell without work takes some time and memory, too.
    std::vector<double> work(finest.cells(), 1);
    for (const WorkAt& each : sweeper_.pending().work(job_.criteria))
      work[finest.cell_of(each.place)] += each.triangles;
    communicator_->divide(finest, work, sweeper_.runner());
    sweeper_.share_phases(*communicator_);
    if (!communicator_->is_first()) sweeper_.counts() = {};  // what all ranks have done alike counts once
    sweeper_.pending().keep_if([&](TriangleId id) { return communicator_->is_at_home(id); });
  }

  void divide_anew(const Tiles& finest) {
    std::vector<double> work(finest.cells(), 0);
    for (const WorkAt& each : sweeper_.pending().work(job_.criteria))
      work[finest.cell_of(each.place)] += estimate(each.triangles);
    add_up_estimates(work, *communicator_);
    for (double& of_cell : work) of_cell += 1;
    sweeper_.pending().add(in_parts_->divide_anew(finest, work, sweeper_.pending().take()));
    sweeper_.share_phases(*communicator_);
  }

  void go_up(const Levels& levels) {
    if (communicator_ == nullptr)
      sweeper_.go_up(levels);
    else
      go_up_in_submesh(levels);
  }

  void go_up_in_submesh(const Levels& levels) {
    const std::vector<QueuedTriangle> rest = sweeper_.pending().take_needing_larger_box();
    RefineCounts in_last_submesh;  // a submesh that was too small does not count
    communicator_->refine_rest(rest, [&](const Communicator::GatheredSubmesh& submesh) {
      return refine_submesh(submesh, [&](Sweeper& in_submesh) {
        in_submesh.pending().add_needing_larger_box(submesh.first);
        in_submesh.go_up(levels);
        in_last_submesh = in_submesh.counts();
        in_last_submesh.left_alone = in_last_submesh.left_alone || in_submesh.pending().any_needs_larger_box();
      });
    });
    sweeper_.counts().add(in_last_submesh);
  }

  void add_up_counts() {
    std::array counts{sweeper_.counts().inserted, sweeper_.counts().segment_splits, sweeper_.counts().refused};
    communicator_->add_up(counts);
    sweeper_.counts().inserted = counts[0];
    sweeper_.counts().segment_splits = counts[1];
    sweeper_.counts().refused = counts[2];
    sweeper_.counts().left_alone = sweeper_.on_any_rank(sweeper_.counts().left_alone);
  }

  const RefinementJob& job_;
  Triangulation& t_;
  const DomainSegments& segments_;
  Communicator* communicator_;
  CommunicatorInParts* in_parts_;               ///< of communicator_; nullptr unless the mesh begins in parts
  Waiting waiting_;                             ///< what waits after go_down_in_submesh()
  std::vector<std::uint64_t> keys_in_submesh_;  ///< of its deferred triangles, on the rank that has refined it
  Sweeper sweeper_;
};

}  // namespace

Result<RefineCounts> refine_by_sweeps(Triangulation& t, const DomainSegments& segments, const Criteria& criteria,
                                      const Options& options, ProgressMonitor& progress, const Schedule& schedule,
                                      const Watcher& watcher, Communicator* communicator) try {
  const RefinementJob job{criteria, options, progress, schedule, watcher};
  Refinement refinement(job, t, segments, communicator);
  if (Status done = refinement.run(); !done) return done.error();
  return std::move(refinement).counts();
} catch (const Stopped& stopped) {
  return stopped.error;
} catch (const NotHeld&) {
  return Error{ErrorKind::internal,
               "a self-check of the refinement failed: a task needed a triangle that its rank does "
               "not hold"};
}

}  // namespace pardel::engine
