#include "refine_by_sweeps.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <optional>
#include <string>
#include <utility>

#include "../../core/support/stopwatch.hpp"
#include "../concurrency/bounding_box.hpp"
#include "../concurrency/lattice_levels.hpp"
#include "../triangulation/compact.hpp"
#include "../triangulation/held.hpp"
#include "../triangulation/radii.hpp"
#include "communicator.hpp"
#include "initial_assessment.hpp"
#include "limits.hpp"
#include "pending_triangles.hpp"
#include "phase.hpp"
#include "tiling_record.hpp"

namespace pardel::engine {
namespace {

/// A level splits triangles whose longest side exceeds this fraction of the side of a cell of the next finer level. The
/// cavities of shorter triangles fit the boxes of the finer level.
constexpr double long_in_finer_cells = 0.25;

/// A leaf of a quadtree is divided if more triangles are expected in it than a share of all, so that there are enough
/// leaves for many threads, and at least and at most these multiples of Options::triangles_per_tile. (A task works on a
/// box of 2.25 leaves, and of four cells in a lattice.) Larger leaves hand fewer triangles on.
constexpr double share_of_leaf = 1.0 / 128, least_per_leaf = 2.5, most_per_leaf = 11;

/// If Options::max_vertices will end the refinement early, leaves that get fewer triangles than this part of a tile
/// gain nothing.
constexpr double least_part_of_tile = 0.25;

/// The decomposition is a quadtree if the work in a cell of a lattice exceeds the average by more than this factor. If
/// all work lies around a point where four cells of sixteen meet, the factor is 4.
constexpr double most_overload = 3;

std::vector<double> per_leaf(const Array<WorkAt>& work, const Quadtree& tree) {
  std::vector<double> sum(tree.cells(), 0);
  for (const WorkAt& each : work) sum[tree.cell_of(each.place)] += each.triangles;
  return sum;
}

Error t1_violated(const Sweep& sweep) {
  return {ErrorKind::internal, "a self-check of the refinement failed: on " + std::to_string(sweep.columns) + " x " +
                                   std::to_string(sweep.rows) + " cells, " + std::to_string(sweep.against_promise) +
                                   " points did not fit the boxes of their cells, although all circumradii there are "
                                   "small enough (a quarter of the side of a cell, an eighth of that of a leaf)"};
}

class Refinement {
 public:
  Refinement(Triangulation& t, const DomainSegments& segments, const Criteria& criteria, const Options& options,
             ProgressMonitor& progress, const Threads& threads, const Schedule& schedule, const Watcher& watcher,
             Communicator* communicator)
      : t_(t),
        segments_(segments),
        criteria_(criteria),
        options_(options),
        schedule_(schedule),
        watcher_(watcher),
        communicator_(communicator),
        in_parts_(communicator == nullptr ? nullptr : communicator->in_parts()),
        assessor_(t, segments, criteria, options),
        threads_(threads),
        runner_(t, assessor_, criteria, options, threads_, schedule),
        pending_(t, assessor_, threads_),
        progress_(progress) {}

  Status run() {
    const Box bounds = bounds_of_all();
    assessor_.expect_within(bounds);
    InitialAssessment initial = assess();
    counts_.left_alone = initial.left_alone;
    pending_.defer(std::move(initial.bad));
    const double whole = initial.estimates.lower_bound + static_cast<double>(progress_.triangles_aside());
    const double needed = communicator_ == nullptr ? whole : whole / communicator_->ranks();
    if (Status fits = check_size(needed, options_); !fits) return fits;
    const Lattice finest = finest_lattice(bounds, initial.estimates.without_angle_bound, options_);
    progress_.start(initial.estimates.with_angle_bound, runner_.vertices().in_use(), runner_.triangles().in_use());

    if (prefers_quadtree(finest))
      refine_in_quadtree(bounds);
    else
      refine_in_lattice(bounds, finest);
    if (communicator_ == nullptr) {
      compact(t_, IndexMoves(runner_.vertices()), IndexMoves(runner_.triangles()), threads_);
    } else {
      add_up_counts();
      communicator_->finish();
    }
    // A triangle is left over if its split point lies in no triangle, if it is blocked, or if the refinement ended
    // early.
    counts_.left_alone = counts_.left_alone || pending_.any_needs_larger_box();
    counts_.tiling = std::move(record_).take();
    return Done{};
  }

  [[nodiscard]] RefineCounts counts() && { return std::move(counts_); }

 private:
  /// From coarse tiles to fine ones. References to the elements stay valid when levels are added.
  using Levels = std::deque<Tiles>;

  [[nodiscard]] Box bounds_of_all() {
    const Box here = bounding_box(threads_, t_.points.size(), [&](std::size_t v) { return t_.points[v]; });
    return in_parts_ != nullptr ? in_parts_->bounds_of_all(here) : here;
  }

  [[nodiscard]] InitialAssessment assess() {
    if (in_parts_ == nullptr) return assess_all(t_, criteria_, assessor_, threads_);
    in_parts_->begin(runner_);
    InitialAssessment initial = assess_all(t_, criteria_, assessor_, threads_, [&](TriangleId id) {
      return in_parts_->holds(id) && communicator_->is_at_home(id);
    });
    TriangleEstimates& e = initial.estimates;
    std::array sums{e.without_angle_bound, e.with_angle_bound, e.lower_bound};
    add_up_estimates(sums, *communicator_);
    e = {sums[0], sums[1], sums[2]};
    return initial;
  }

  [[nodiscard]] bool prefers_quadtree(const Lattice& finest) const {
    if (options_.decomposition == Decomposition::quadtree || options_.decomposition == Decomposition::paper_quadtree)
      return true;
    const bool may = options_.decomposition == Decomposition::automatic && options_.cells[0] == 0;
    return may && criteria_.depends_on_place() && finest.cells() > 1 &&
           overload(t_, criteria_, assessor_, finest, threads_) > most_overload;
  }

  void refine_in_lattice(const Box& bounds, const Lattice& finest) {
    Levels levels;
    for (const Lattice& lattice : lattice_levels(bounds, finest)) levels.emplace_back(lattice);
    go_down(levels);
    lay_finest(bounds, levels);
    const Deferral shorter_half{.last_key = median_key()};
    pending_.add(std::exchange(waiting_, {}));
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
      Quadtree finer = *present.quadtree();
      const Array<WorkAt> work = pending_.work(criteria_);
      const double most = allowed(work);
      for (int halvings = 0; halvings < 2; ++halvings) finer = finer.divided(per_leaf(work, finer), most);
      if (finer.cells() == present.cells()) break;
      refine_due(present, short_enough_for(*present.quadtree(), finer));
      if (counts_.budget_reached) break;
      levels.emplace_back(std::move(finer));
    }
    record_.set_finest(levels.back(), bounds, largest_radii(t_, runner_.triangles(), threads_), made());
    std::vector<Deferral> shorter_half;
    for (const unsigned key : pending_.median_keys(levels.back())) shorter_half.push_back({.last_key = key});
    if (communicator_ != nullptr) divide(levels.back());
    refine_on_finest(levels.back(), Deferrals(std::move(shorter_half)));
    go_up(levels);
  }

  /// The number of triangles that may be expected in a leaf.
  [[nodiscard]] double allowed(const Array<WorkAt>& work) const {
    double all = 0;
    for (const WorkAt& each : work) all += each.triangles;
    const double tile = options_.triangles_per_tile;
    const double expected_for_each_made = all / (2 * static_cast<double>(runner_.vertices().available()));
    return std::max(std::clamp(share_of_leaf * all, least_per_leaf * tile, most_per_leaf * tile),
                    least_part_of_tile * tile * expected_for_each_made);
  }

  /// For each leaf: the rule that leaves triangles to the finer leaves in it. With the paper's quadtree, the leaves
  /// around it count, too: in the buffer zone of a finer leaf, all circumradii have to fit.
  [[nodiscard]] Deferrals short_enough_for(const Quadtree& tree, const Quadtree& finer) const {
    const bool by_radius = is_of_the_paper(options_.decomposition);
    std::vector<double> bounds(tree.cells(), INFINITY);
    for (Index cell = 0; cell < finer.cells(); ++cell) {
      const double most = by_radius ? finer.radius_that_fits(cell) : long_in_finer_cells * finer.side_of(cell);
      double& bound = bounds[tree.cell_of(finer.centre_of(cell))];
      bound = std::min(bound, most * most);
    }
    std::vector<Deferral> rules;
    for (Index cell = 0; cell < tree.cells(); ++cell) {
      if (!by_radius) {
        rules.push_back({.longest_squared = bounds[cell]});
        continue;
      }
      double around = bounds[cell];
      for (const Index other : tree.touching(cell)) around = std::min(around, bounds[other]);
      rules.push_back({.squared_radius = around});
    }
    return Deferrals(std::move(rules));
  }

  [[nodiscard]] Deferral short_enough_for(const Lattice& finer) const {
    if (options_.decomposition == Decomposition::paper) {
      const double largest = finer.side() / Lattice::radii_per_side;
      return {.squared_radius = largest * largest};
    }
    const double longest = long_in_finer_cells * finer.side();
    return {.longest_squared = longest * longest};
  }

  /// Splits, on each level, the triangles that are too long for the next finer level. Triangles that are short enough
  /// wait for a finer level. Most triangles of a fine input are short from the start. They are taken out first, so that
  /// the coarse levels do not examine them. (With the paper's decomposition, levels compare circumradii instead of
  /// lengths, and no triangle is taken out.)
  void go_down(const Levels& levels) {
    pending_.set_aside(short_enough_for(*levels.back().lattice()));
    if (in_parts_ != nullptr)
      go_down_in_submesh(levels);
    else
      refine_coarse_levels(levels);
    pending_.bring_back();
  }

  void refine_coarse_levels(const Levels& levels) {
    for (std::size_t level = 0; level + 1 < levels.size(); ++level)
      refine_due(levels[level], short_enough_for(*levels[level + 1].lattice()));
  }

  void begin_submesh(const Communicator::GatheredSubmesh& submesh) {
    changed_.emplace();
    needs_more_at_ = &submesh.needs_more_at;
    runner_.begin_submesh();
  }
  [[nodiscard]] const DomainSegments& segments_of(const Communicator::GatheredSubmesh& submesh) const {
    return submesh.segments != nullptr ? *submesh.segments : segments_;
  }

  /// What waits afterwards is added to the pending triangles when the median of the keys is known: for the median, it
  /// counts on the rank that has refined.
  void go_down_in_submesh(const Levels& levels) {
    const Waiting due = pending_.take();
    RefineCounts in_last_submesh;  // a submesh that was too small does not count
    const auto refine = [&](const Communicator::GatheredSubmesh& submesh, std::vector<TriangleId>& changed) {
      const Threads one(1, threads_.stop);  // see go_up_in_submesh()
      Refinement in_submesh(submesh.t, segments_of(submesh), criteria_, options_, progress_, one, schedule_, watcher_,
                            nullptr);
      in_submesh.defer_again(submesh.first);
      in_submesh.begin_submesh(submesh);
      in_submesh.refine_coarse_levels(levels);
      in_last_submesh = in_submesh.counts_;
      keys_in_submesh_ = in_submesh.pending_.count_keys();
      changed = *std::move(in_submesh.changed_);
      return in_submesh.pending_.take();
    };
    waiting_ = in_parts_->refine_coarse(due.deferred, refine);
    counts_.add(in_last_submesh);
  }

  /// Puts triangles into the list of deferred ones, as assess_all() does.
  void defer_again(std::span<const QueuedTriangle> triangles) {
    Array<Deferred> bad;
    for (const QueuedTriangle triangle : triangles)
      if (const Assessment a = assessor_.assess(triangle.id()); a.need != Assessment::Need::nothing)
        bad.push_back({assessor_.entry(triangle.id(), a), a});
    pending_.defer(std::move(bad));
  }

  [[nodiscard]] unsigned median_key() {
    std::vector<std::uint64_t> counts = pending_.count_keys();
    for (std::size_t key = 0; key < keys_in_submesh_.size(); ++key) counts[key] += keys_in_submesh_[key];
    if (in_parts_ != nullptr) communicator_->add_up(counts);
    return PendingTriangles::median_key(counts);
  }

  /// Measures the circumradii. With the paper's decomposition, widens the cells of the finest lattice to the size that
  /// the largest circumradius demands.
  void lay_finest(const Box& bounds, Levels& levels) {
    Radii largest = largest_radii(t_, runner_.triangles(), threads_);
    if (in_parts_ != nullptr) {
      std::array of_all{largest.radius, largest.ratio, largest.area};
      in_parts_->take_largest(of_all);
      largest = {of_all[0], of_all[1], of_all[2]};
    }
    if (options_.decomposition == Decomposition::paper)
      levels.back() =
          Tiles(with_cells_at_least(Lattice::radii_per_side * largest.radius, bounds, *levels.back().lattice()));
    record_.set_finest(levels.back(), bounds, largest, made());
  }

  /// Splits the shorter half of the triangles first, in all cells, then the longer half. The points that split short
  /// triangles also split many long ones. In the opposite order, the points for long triangles would be additional.
  /// Tiles that finish one after the other do not produce this order by themselves. A single queue for all triangles
  /// does not produce it either, and makes larger meshes.
  void refine_on_finest(const Tiles& finest, const Deferrals& longer_half) {
    refine_due(finest, longer_half);
    refine_due(finest, {});
  }

  /// From here on, each rank refines its own cells of the finest tiles. Each triangle that waits waits on one rank.
  void divide(const Tiles& finest) {
    if (in_parts_ != nullptr) return divide_anew(finest);
    // A cell without work takes some time and memory, too.
    std::vector<double> work(finest.cells(), 1);
    for (const WorkAt& each : pending_.work(criteria_)) work[finest.cell_of(each.place)] += each.triangles;
    communicator_->divide(finest, work, runner_);
    runner_.set_communicator(communicator_);
    is_divided_ = true;
    if (!communicator_->is_first()) counts_ = {};  // what all ranks have done alike counts once
    pending_.keep_if([&](TriangleId id) { return communicator_->is_at_home(id); });
  }

  void divide_anew(const Tiles& finest) {
    std::vector<double> work(finest.cells(), 0);
    for (const WorkAt& each : pending_.work(criteria_)) work[finest.cell_of(each.place)] += estimate(each.triangles);
    add_up_estimates(work, *communicator_);
    for (double& of_cell : work) of_cell += 1;
    pending_.add(in_parts_->divide_anew(finest, work, pending_.take()));
    runner_.set_communicator(communicator_);
    is_divided_ = true;
  }

  /// Splits the triangles whose cavities fit no box of a level, on the coarser levels, which have larger boxes. Also
  /// tries the blocked triangles again: a vertex may now lie between the split point of a triangle and the segment that
  /// blocked it. As long as a pass over the levels inserts vertices, another one tries the triangles that still wait.
  void go_up(const Levels& levels) {
    if (communicator_ != nullptr) return go_up_in_submesh(levels);
    if (counts_.budget_reached) return;
    bool goes_on = refine_waiting(levels, levels.size() - 1) || levels.size() == 1;
    while (goes_on && pending_.any_needs_larger_box()) goes_on = refine_waiting(levels, levels.size());
  }

  /// A pass over so many of the coarsest levels, from fine to coarse. Returns true if it has inserted vertices.
  bool refine_waiting(const Levels& levels, std::size_t count) {
    const std::uint64_t before = made();
    for (std::size_t level = count; level-- > 0;)
      sweep_to_fixpoint(levels[level], pending_.take_needing_larger_box_by_cell(levels[level]), {});
    return made() > before;
  }

  [[nodiscard]] std::uint64_t made() const { return counts_.inserted + counts_.segment_splits; }

  void go_up_in_submesh(const Levels& levels) {
    const std::vector<QueuedTriangle> rest = pending_.take_needing_larger_box();
    RefineCounts in_last_submesh;  // a submesh that was too small does not count
    communicator_->refine_rest(rest, [&](const Communicator::GatheredSubmesh& submesh) {
      // On one thread: tasks on several would all write to the triangle that stands for those beyond the submesh.
      const Threads one(1, threads_.stop);
      Refinement in_submesh(submesh.t, segments_of(submesh), criteria_, options_, progress_, one, schedule_, watcher_,
                            nullptr);
      in_submesh.pending_.add_needing_larger_box(submesh.first);
      in_submesh.begin_submesh(submesh);
      in_submesh.go_up(levels);
      in_last_submesh = in_submesh.counts_;
      in_last_submesh.left_alone = in_last_submesh.left_alone || in_submesh.pending_.any_needs_larger_box();
      return *std::move(in_submesh.changed_);
    });
    counts_.add(in_last_submesh);
  }

  void refine_due(const Tiles& tiles, const Deferrals& later) {
    if (counts_.budget_reached) return;
    sweep_to_fixpoint(tiles, pending_.take_due_by_cell(tiles, later), later);
  }

  void sweep_to_fixpoint(const Tiles& tiles, SeedsByCell seeds, const Deferrals& later) {
    const auto waiting = [&] {
      return !counts_.budget_reached &&
             on_any_rank(std::any_of(seeds.begin(), seeds.end(), [](const auto& of_cell) { return !of_cell.empty(); }));
    };
    // A triangle may need a point in one cell, then a point in another cell. Two tasks could hand it on to each other
    // for ever. After two sweeps without an insertion both have tried, and the triangle needs a larger box.
    for (int idle = 0; idle < 2 && waiting();) idle = sweep(tiles, seeds, later) > 0 ? 0 : idle + 1;
    for (const std::vector<QueuedTriangle>& of_cell : seeds) pending_.add_needing_larger_box(of_cell);
  }

  [[nodiscard]] bool on_any_rank(bool here) const {
    if (!is_divided_) return here;
    std::uint64_t ranks = here ? 1 : 0;
    communicator_->add_up({&ranks, 1});
    return ranks > 0;
  }

  void add_up_counts() {
    std::array counts{counts_.inserted, counts_.segment_splits, counts_.refused};
    communicator_->add_up(counts);
    counts_.inserted = counts[0];
    counts_.segment_splits = counts[1];
    counts_.refused = counts[2];
    counts_.left_alone = on_any_rank(counts_.left_alone);
  }

  /// Replaces the counts of this rank by those of all ranks.
  void add_up(Sweep& sweep) const {
    std::array counts{sweep.inserted, sweep.to_other_cells, sweep.beyond_box, sweep.out_of_numbers,
                      sweep.against_promise};
    communicator_->add_up(counts);
    sweep.inserted = counts[0];
    sweep.to_other_cells = counts[1];
    sweep.beyond_box = counts[2];
    sweep.out_of_numbers = counts[3];
    sweep.against_promise = counts[4];
  }

  /// Returns the number of vertices inserted.
  std::uint64_t sweep(const Tiles& tiles, SeedsByCell& seeds, const Deferrals& later) {
    Stopwatch watch;
    Sweep done{tiles.columns(), tiles.rows()};
    for (unsigned colour = 0; colour < tiles.colours(); ++colour) {
      if (!is_divided_ && runner_.vertices().available() == 0) break;  // tasks could only hand their triangles on
      run_phase(tiles, colour, seeds, later, done);
    }
    if (is_divided_) add_up(done);
    done.seconds = watch.seconds();
    record_.add_sweep(done);
    if (runner_.vertices().available() == 0) counts_.budget_reached = counts_.left_alone = true;
    if (Status fine = check_after(done); !fine) throw Stopped{fine.error()};
    return done.inserted;
  }

  void run_phase(const Tiles& tiles, unsigned colour, SeedsByCell& seeds, const Deferrals& later, Sweep& done) {
    std::vector<PlannedTask> tasks = runner_.plan(tiles, colour, later, seeds);
    if (changed_)
      for (PlannedTask& task : tasks) task.lists_changes = true;
    if (!tasks.empty()) runner_.run(tiles, tasks, later, [this](std::uint64_t made) { progress_.report(made); });
    if (is_divided_) communicator_->exchange_changes(tasks);
    for (const PlannedTask& task : tasks) {
      threads_.ask();
      if (changed_) changed_->insert(changed_->end(), task.result.changed.begin(), task.result.changed.end());
      for (const HandedOn& h : task.result.handed_on) seeds[h.cell].push_back(h.triangle);
      collect(task, done);
      if (!task.elsewhere) record_.add_task(tiles, task.cell, task.thread);
    }
    pending_.defer_all_of(tasks);
    progress_.phase_ended(runner_.vertices().in_use(), runner_.triangles().in_use());
  }

  [[nodiscard]] Status check_after(const Sweep& sweep) const {
    if (runner_.triangles().available() < 2) return too_many_triangles();
    if (outgrows_memory(progress_.vertices(), options_)) return too_much_memory(options_);
    if (sweep.against_promise > 0) return t1_violated(sweep);
    if (!watcher_) return Done{};
    return watcher_(compacted_copy(t_, runner_.vertices(), runner_.triangles(), threads_), sweep);
  }

  void collect(const PlannedTask& task, Sweep& sweep) {
    const TaskResult& r = task.result;
    if (needs_more_at_ != nullptr)
      needs_more_at_->insert(needs_more_at_->end(), r.needs_more_at.begin(), r.needs_more_at.end());
    pending_.add_needing_larger_box(task.outside_box);
    pending_.add_needing_larger_box(r.needs_larger_box);
    pending_.add_needing_larger_box(r.blocked);
    counts_.inserted += r.inserted;
    counts_.segment_splits += r.segment_splits;
    counts_.refused += r.refused;
    counts_.left_alone = counts_.left_alone || r.left_alone;
    sweep.inserted += r.inserted + r.segment_splits;
    sweep.largest_task = std::max(sweep.largest_task, r.inserted + r.segment_splits);
    sweep.to_other_cells += r.handed_on.size() - r.out_of_numbers;
    sweep.beyond_box += task.outside_box.size() + r.needs_larger_box.size();
    sweep.out_of_numbers += r.out_of_numbers;
    sweep.against_promise += r.against_promise + task.against_promise;
  }

  Triangulation& t_;
  const DomainSegments& segments_;
  const Criteria& criteria_;
  const Options& options_;
  const Schedule& schedule_;
  const Watcher& watcher_;
  Communicator* communicator_;
  CommunicatorInParts* in_parts_;  ///< of communicator_; nullptr unless the mesh begins in parts
  bool is_divided_ = false;
  Waiting waiting_;                                 ///< what waits after go_down_in_submesh()
  std::vector<std::uint64_t> keys_in_submesh_;      ///< of its deferred triangles, on the rank that has refined it
  std::optional<std::vector<TriangleId>> changed_;  ///< in a submesh: the triangles made, with repetitions
  std::vector<VertexId>* needs_more_at_ = nullptr;  ///< of the submesh
  Assessor assessor_;
  Threads threads_;
  PhaseRunner runner_;
  PendingTriangles pending_;
  ProgressMonitor& progress_;
  TilingRecord record_;
  RefineCounts counts_;
};

}  // namespace

Result<RefineCounts> refine_by_sweeps(Triangulation& t, const DomainSegments& segments, const Criteria& criteria,
                                      const Options& options, ProgressMonitor& progress, const Schedule& schedule,
                                      const Watcher& watcher, Communicator* communicator) try {
  Refinement refinement(t, segments, criteria, options, progress, progress.threads(), schedule, watcher, communicator);
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
