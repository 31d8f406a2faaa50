#include "refine_by_sweeps.hpp"

#include <array>
#include <utility>

#include "../decomposition/bounding_box.hpp"
#include "../decomposition/lattice_levels.hpp"
#include "../quality/estimates.hpp"
#include "../triangulation/held.hpp"
#include "../triangulation/limits.hpp"
#include "../triangulation/radii.hpp"
#include "communicator.hpp"
#include "initial_assessment.hpp"
#include "level_rules.hpp"
#include "one_process.hpp"
#include "sweeper.hpp"

namespace pardel::engine {
namespace {

/// The decomposition is a quadtree if the work in a cell of a lattice exceeds the average by more than this factor. If
/// all work lies around a point where four cells of sixteen meet, the factor is 4.
constexpr double most_overload = 3;

bool prefers_quadtree(const Lattice& finest, const Triangulation& t, const RefinementJob& job,
                      const Assessor& assessor) {
  if (job.options.decomposition == Decomposition::quadtree ||
      job.options.decomposition == Decomposition::paper_quadtree)
    return true;
  const bool may = job.options.decomposition == Decomposition::automatic && job.options.cells[0] == 0;
  return may && job.criteria.depends_on_place() && finest.cells() > 1 &&
         overload(t, job.criteria, assessor, finest, job.progress.threads()) > most_overload;
}

/// The counts of the next submesh. What was inserted into the one before, which was too small, is discarded.
void replace(RefineCounts& counts, const RefineCounts& of_next) {
  const std::uint64_t discarded = counts.discarded + counts.inserted + counts.segment_splits;
  counts = of_next;
  counts.discarded = discarded;
}

/// Takes a refinement through the levels of a decomposition: which tiles they have, and what is split on each.
class Refinement {
 public:
  Refinement(const RefinementJob& job, Triangulation& t, const DomainSegments& segments, Communicator& communicator)
      : job_(job),
        t_(t),
        segments_(segments),
        communicator_(communicator),
        sweeper_(job, t, segments, job.progress.threads(), communicator) {}

  Status run() {
    const Box bounds = bounds_of_all();
    sweeper_.expect_within(bounds);
    InitialAssessment initial = assess();
    sweeper_.counts().left_alone = initial.left_alone;
    sweeper_.pending().defer(std::move(initial.bad));
    const double whole = initial.estimates.lower_bound + static_cast<double>(job_.progress.triangles_aside());
    if (Status fits = check_size(whole / communicator_.ranks(), job_.options); !fits) return fits;
    const Lattice finest = finest_lattice(bounds, initial.estimates.without_angle_bound, job_.options);
    job_.progress.start(initial.estimates.with_angle_bound, sweeper_.runner().vertices().in_use(),
                        sweeper_.runner().triangles().in_use());
    sweeper_.use(job_.progress.threads());

    if (prefers_quadtree(finest, t_, job_, sweeper_.assessor()))
      refine_in_quadtree(bounds);
    else
      refine_in_lattice(bounds, finest);
    sweeper_.add_up_counts();
    communicator_.finish(t_, sweeper_.runner(), sweeper_.threads());
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
    return communicator_.bounds_of_all(here);
  }

  [[nodiscard]] InitialAssessment assess() {
    communicator_.begin(sweeper_.runner());
    InitialAssessment initial =
        assess_all(t_, job_.criteria, sweeper_.assessor(), sweeper_.threads(), communicator_.counted());
    TriangleEstimates& e = initial.estimates;
    std::array sums{e.without_angle_bound, e.with_angle_bound, e.lower_bound};
    communicator_.add_up_estimates(sums);
    e = {sums[0], sums[1], sums[2]};
    return initial;
  }

  void refine_in_lattice(const Box& bounds, const Lattice& finest) {
    Levels levels;
    for (const Lattice& lattice : lattice_levels(bounds, finest)) levels.emplace_back(lattice);
    go_down(levels);
    lay_finest(bounds, levels);
    const Deferral shorter_half{.last_key = median_key()};
    sweeper_.pending().add(std::exchange(waiting_, {}));
    divide(levels.back());
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
    divide(levels.back());
    refine_on_finest(levels.back(), Deferrals(std::move(shorter_half)));
    go_up(levels);
  }

  /// Splits, on each level, the triangles that are too long for the next finer level. Triangles that are short enough
  /// wait for a finer level. Most triangles of a fine input are short from the start. They are taken out first, so that
  /// the coarse levels do not examine them. (With the paper's decomposition, levels compare circumradii instead of
  /// lengths, and no triangle is taken out.) What waits after work in a submesh is added to the pending triangles when
  /// the median of the keys is known: for the median, it counts on the rank that has refined.
  void go_down(const Levels& levels) {
    sweeper_.pending().set_aside(short_enough_for(*levels.back().lattice(), job_.options.decomposition));
    RefineCounts in_last_submesh;
    waiting_ = communicator_.refine_coarse(
        {.refine_here = [&] { sweeper_.refine_coarse_levels(levels); },
         .take_due = [&] { return sweeper_.pending().take().deferred; },
         .refine_submesh =
             [&](const Communicator::GatheredSubmesh& submesh, std::vector<TriangleId>& changed) {
               Waiting waiting;
               changed = refine_submesh(submesh, [&](Sweeper& in_submesh) {
                 in_submesh.defer_again(submesh.first);
                 in_submesh.refine_coarse_levels(levels);
                 replace(in_last_submesh, in_submesh.counts());
                 keys_in_submesh_ = in_submesh.pending().count_keys();
                 waiting = in_submesh.pending().take();
               });
               return waiting;
             }});
    sweeper_.counts().add(in_last_submesh);
    sweeper_.pending().bring_back();
  }

  /// Refines a gathered submesh as work(sweeper) does. Returns the changed triangles. On one thread: tasks on several
  /// would all write to the triangle that stands for those beyond the submesh.
  template <class Work>
  std::vector<TriangleId> refine_submesh(const Communicator::GatheredSubmesh& submesh, const Work& work) {
    const DomainSegments& segments = submesh.segments != nullptr ? *submesh.segments : segments_;
    OneProcess one_process;
    Sweeper sweeper(job_, submesh.t, segments, Threads(1, sweeper_.threads().stop), one_process);
    sweeper.begin_submesh(submesh);
    work(sweeper);
    return sweeper.take_changed();
  }

  [[nodiscard]] unsigned median_key() {
    std::vector<std::uint64_t> counts = sweeper_.pending().count_keys();
    for (std::size_t key = 0; key < keys_in_submesh_.size(); ++key) counts[key] += keys_in_submesh_[key];
    communicator_.add_up(counts);
    return PendingTriangles::median_key(counts);
  }

  /// Measures the circumradii. With the paper's decomposition, widens the cells of the finest lattice to the size that
  /// the largest circumradius demands.
  void lay_finest(const Box& bounds, Levels& levels) {
    Radii largest = largest_radii(t_, sweeper_.runner().triangles(), sweeper_.threads());
    std::array of_all{largest.radius, largest.ratio, largest.area};
    communicator_.take_largest(of_all);
    largest = {of_all[0], of_all[1], of_all[2]};
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

  /// From here on, each rank refines its own cells of the finest tiles.
  void divide(const Tiles& finest) {
    const auto work_of_cells = [&] {
      std::vector<double> work(finest.cells(), 0);
      for (const WorkAt& each : sweeper_.pending().work(job_.criteria))
        work[finest.cell_of(each.place)] += estimate(each.triangles);
      communicator_.add_up_estimates(work);
      // A cell without work takes some time and memory, too.
      for (double& of_cell : work) of_cell += 1;
      return work;
    };
    communicator_.divide({finest, work_of_cells, sweeper_.pending(), sweeper_.counts()}, sweeper_.runner());
  }

  void go_up(const Levels& levels) {
    RefineCounts in_last_submesh;
    communicator_.refine_rest({.refine_here = [&] { sweeper_.go_up(levels); },
                               .take_rest = [&] { return sweeper_.pending().take_needing_larger_box(); },
                               .refine_submesh =
                                   [&](const Communicator::GatheredSubmesh& submesh) {
                                     return refine_submesh(submesh, [&](Sweeper& in_submesh) {
                                       in_submesh.pending().add_needing_larger_box(submesh.first);
                                       in_submesh.go_up(levels);
                                       replace(in_last_submesh, in_submesh.counts());
                                       in_last_submesh.left_alone =
                                           in_last_submesh.left_alone || in_submesh.pending().any_needs_larger_box();
                                     });
                                   }});
    sweeper_.counts().add(in_last_submesh);
  }

  const RefinementJob& job_;
  Triangulation& t_;
  const DomainSegments& segments_;
  Communicator& communicator_;
  Waiting waiting_;                             ///< what waits in addition after go_down()
  std::vector<std::uint64_t> keys_in_submesh_;  ///< of its deferred triangles, on the rank that has refined it
  Sweeper sweeper_;
};

}  // namespace

Result<RefineCounts> refine_by_sweeps(Triangulation& t, const DomainSegments& segments, const Criteria& criteria,
                                      const Options& options, ProgressMonitor& progress, const Schedule& schedule,
                                      const Watcher& watcher, Communicator& communicator) try {
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

Result<RefineCounts> refine_by_sweeps(Triangulation& t, const DomainSegments& segments, const Criteria& criteria,
                                      const Options& options, ProgressMonitor& progress, const Schedule& schedule,
                                      const Watcher& watcher) {
  OneProcess one_process;
  return refine_by_sweeps(t, segments, criteria, options, progress, schedule, watcher, one_process);
}

}  // namespace pardel::engine
