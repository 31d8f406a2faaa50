#include "refine_by_sweeps.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "../concurrency/bounding_box.hpp"
#include "../concurrency/parallel_arrays.hpp"
#include "../concurrency/parallel_for.hpp"
#include "compact.hpp"
#include "levels.hpp"
#include "limits.hpp"
#include "phase.hpp"
#include "radii.hpp"
#include "snapshot.hpp"
#include "take_due.hpp"

namespace pardel::engine {
namespace {

/// What quality alone makes of a triangle of the input, at the very least.
constexpr double triangles_per_input_triangle = 1.7;
/// A vertex makes two triangles; a fifth to spare.
constexpr double insertions_per_triangle = 0.6;
/// A level splits what is longer than this part of the next finer level's cell: shorter triangles have
/// cavities that fit that level's boxes.
constexpr double long_in_finer_cells = 0.25;

class Refinement {
 public:
  Refinement(Triangulation& t, const DomainSegments& segments, const Criteria& criteria, const Options& options,
             const Schedule& schedule, const Watcher& watcher)
      : t_(t),
        criteria_(criteria),
        options_(options),
        watcher_(watcher),
        judge_(t, segments, criteria, options),
        crew_(t, judge_, criteria, options, schedule),
        threads_(crew_.threads()) {}

  Status run() {
    const Outlook outlook = defer_everything_bad();
    if (Status fits = check_size(outlook.needed, options_); !fits) return fits;
    const Box bounds = bounding_box(threads_, t_.points.size(), [&](std::size_t v) { return t_.points[v]; });
    std::vector<Lattice> levels = levels_down_to(bounds, finest_lattice(bounds, outlook.estimate, options_));
    estimate_ = outlook.expected;
    if (options_.max_vertices > 0) estimate_ = std::min(estimate_, 2.0 * static_cast<double>(options_.max_vertices));
    triangles_before_ = crew_.triangles().in_use();
    vertices_before_ = crew_.vertices().in_use();

    go_down(levels);
    lay_finest(bounds, levels);
    // At the finest, everywhere the shorter half of the work comes before the longer: points put in for long
    // triangles would only be in the way of those that short ones need anyway. Tiles that finish one by one cannot
    // have this order by themselves, and neither has one queue over everything: it makes larger meshes.
    sweep_what_is_due(levels.back(), {.last_key = median_key()});
    sweep_what_is_due(levels.back(), {});
    // Up: what no box of a level could hold gets a larger one.
    for (std::size_t level = levels.size() - 1; level-- > 0;)
      sweep_to_fixpoint(levels[level], filed(levels[level], std::exchange(stuck_, {}), {}), {});
    close_ranks(t_, crew_.vertices(), crew_.triangles(), threads_);
    counts_.left_alone = counts_.left_alone || !stuck_.empty();  // with a point that is nowhere
    if (failure_) return *failure_;
    if (cancelled_.load()) return Error{ErrorKind::cancelled, "the caller asked to stop"};
    return Done{};
  }

  [[nodiscard]] RefineCounts counts() && { return std::move(counts_); }

 private:
  using Inbox = std::vector<std::vector<Queued>>;  ///< per cell, what waits for its task

  struct Outlook {
    double estimate = 0;  ///< of the final number of triangles, whatever the bound on angles: it sizes the tiles
    double expected = 0;  ///< the same with regard to that bound
    double needed = 0;    ///< no mesh with fewer has the areas asked for
  };

  [[nodiscard]] bool out_of_triangles() const { return crew_.triangles().available() < 2; }
  static Error promise_broken(const Sweep& sweep) {
    return {ErrorKind::internal, "the refinement went wrong: on a lattice of " + std::to_string(sweep.columns) + " x " +
                                     std::to_string(sweep.rows) + " cells, " + std::to_string(sweep.against_promise) +
                                     " points did not fit the boxes of their cells, though no circumradius there "
                                     "exceeds a quarter of a cell's side"};
  }

  [[nodiscard]] Deferral short_enough_for(const Lattice& finer) const {
    if (options_.decomposition == Decomposition::paper) {
      const double largest = finer.side() / Lattice::radii_per_side;
      return {.squared_radius = largest * largest};
    }
    const double longest = long_in_finer_cells * finer.side();
    return {.longest_squared = longest * longest};
  }

  /// Measures, and for the paper's decomposition widens the cells to what the measure allows.
  void lay_finest(const Box& bounds, std::vector<Lattice>& levels) {
    const Radii largest = largest_radii(t_, crew_.triangles(), threads_);
    if (options_.decomposition == Decomposition::paper)
      levels.back() = with_sides_of(bounds, levels.back(), Lattice::radii_per_side * largest.radius);
    Tiling& tiling = counts_.tiling;
    tiling.columns = levels.back().columns();
    tiling.rows = levels.back().rows();
    tiling.cell_width = levels.back().width();
    tiling.cell_height = levels.back().height();
    tiling.low = {bounds.min_x, bounds.min_y};
    tiling.high = {bounds.max_x, bounds.max_y};
    tiling.thread_of_cell.assign(levels.back().cells(), -1);
    finest_ = &levels.back();
    tiling.vertices_before = counts_.inserted + counts_.segment_splits;
    tiling.largest_radius = largest.radius;
    tiling.radius_by_t3 = radius_bound(largest.ratio, largest.area);
    tiling.radius_by_t3_sharp = sharp_radius_bound(largest.ratio, largest.area);
  }

  /// Defers all triangles that ask for something; how many triangles the result may have.
  Outlook defer_everything_bad() {
    const std::size_t blocks = block_count(t_.slots.size());
    std::vector<Outlook> outlook(blocks);
    std::vector<std::vector<Deferred>> bad(blocks);
    std::vector<char> left_alone(blocks, 0);
    parallel_blocks(threads_, t_.slots.size(), [&](std::size_t first, std::size_t last, std::size_t block) {
      for (std::size_t id = first; id < last; ++id) {
        const auto triangle = static_cast<TriangleId>(id);
        const Shape shape(t_, t_.slots[triangle]);
        const double wanted = wanted_by(triangle, shape);
        outlook[block].estimate += std::max(triangles_per_input_triangle, wanted);
        outlook[block].expected += std::max(criteria_.triangles_by_shape(), wanted);
        outlook[block].needed += criteria_.triangles_needed(shape, judge_.region_of(triangle));
        const Assessment a = judge_.assess(triangle, shape);
        if (a.need != Assessment::Need::nothing) bad[block].push_back({judge_.queued(triangle, a), a});
        if (a.left_alone) left_alone[block] = 1;
      }
    });
    append_blocks(threads_, bad, deferred_);
    counts_.left_alone = std::any_of(left_alone.begin(), left_alone.end(), [](char c) { return c != 0; });
    Outlook all;
    for (const Outlook& block : outlook) {
      all.estimate += block.estimate;
      all.expected += block.expected;
      all.needed += block.needed;
    }
    return all;
  }

  [[nodiscard]] double wanted_by(TriangleId id, const Shape& shape) const {
    return criteria_.triangles_wanted(shape, judge_.region_of(id));
  }

  [[nodiscard]] bool go_on() const { return !cancelled_.load(std::memory_order_relaxed) && !counts_.budget_reached; }

  /// Asked by tasks now and then; the caller hears of it on its own thread only. Vertices only become more, and what
  /// tasks have told of is no more than there is: so whether a mesh outgrows its memory depends on the mesh alone.
  bool report(int thread, std::uint64_t vertices_made) {
    made_ += 2 * vertices_made;
    if (outgrows_memory(vertices_before_ + made_.load() / 2, options_)) cancelled_ = true;  // judge_sweep says why
    if (cancelled_.load(std::memory_order_relaxed)) return false;
    if (thread == 0 && options_.progress) {
      shown_ = std::max(shown_, triangles_before_ + made_.load());
      if (!options_.progress({shown_, estimate_})) cancelled_ = true;
    }
    return !cancelled_.load(std::memory_order_relaxed);
  }

  /// Of the deferred, those that are gone by now included; what is larger is the longer half.
  [[nodiscard]] unsigned median_key() const {
    std::vector<std::size_t> count(BucketQueue::last + 1, 0);
    for (const Deferred& d : deferred_) ++count[d.key];
    unsigned key = 0;
    for (std::size_t up_to = count[0]; up_to <= deferred_.size() / 2 && key < BucketQueue::last;) up_to += count[++key];
    return key;
  }

  /// What is long at a level is split there; what gets short enough waits for a finer one. Most of a fine input is
  /// short from the start and set aside, lest every level goes through it (but for the paper's levels, which go by
  /// radii).
  void go_down(const std::vector<Lattice>& levels) {
    Array<Deferred> for_the_finest = std::exchange(deferred_, {});
    deferred_ =
        take_due(threads_, for_the_finest, short_enough_for(levels.back()), [](const Deferred& d) { return d; });
    for (std::size_t level = 0; level + 1 < levels.size(); ++level)
      sweep_what_is_due(levels[level], short_enough_for(levels[level + 1]));
    for_the_finest.append(deferred_.span());
    deferred_.swap(for_the_finest);
  }

  void sweep_what_is_due(const Lattice& lattice, const Deferral& later) {
    Array<Queued> due = take_due(threads_, deferred_, later, [](const Deferred& d) { return d.triangle; });
    Inbox inbox = filed(lattice, due.span(), later);
    Array<Queued>().swap(due);
    sweep_to_fixpoint(lattice, std::move(inbox), later);
  }

  /// By the cells of the points that they ask for; what `later` applies to is deferred.
  Inbox filed(const Lattice& lattice, std::span<const Queued> pending, const Deferral& later) {
    Array<Index> cell;
    cell.resize_uninitialised(pending.size());
    std::vector<std::vector<Deferred>> not_yet(block_count(pending.size()));
    parallel_blocks(threads_, pending.size(), [&](std::size_t first, std::size_t last, std::size_t block) {
      for (std::size_t i = first; i < last; ++i) {
        cell[i] = no_index;
        if (!judge_.is_current(pending[i])) continue;
        const TriangleId id = pending[i].id();
        const Shape shape(t_, t_.slots[id]);
        const Assessment a = judge_.assess(id, shape);
        if (a.need == Assessment::Need::nothing) continue;
        if (later.applies_to(a, shape))
          not_yet[block].push_back({pending[i], a});
        else
          cell[i] = lattice.cell_of(judge_.point_for(id, a));
      }
    });
    append_blocks(threads_, not_yet, deferred_);
    Inbox inbox(lattice.cells());
    visit_by_cell(threads_, cell.span(), lattice.cells(),
                  [&](Index to, std::size_t i) { inbox[to].push_back(pending[i]); });
    return inbox;
  }

  void sweep_to_fixpoint(const Lattice& lattice, Inbox inbox, const Deferral& later) {
    const auto waiting = [&] {
      return std::any_of(inbox.begin(), inbox.end(), [](const auto& b) { return !b.empty(); });
    };
    // A triangle may ask now for a point in one cell, now for one in another, and be sent to and fro for ever: what
    // two sweeps without an insertion have tried wherever it asked to be needs a larger box.
    for (int idle = 0; idle < 2 && waiting() && go_on();) {
      idle = sweep(lattice, inbox, later) > 0 ? 0 : idle + 1;
    }
    for (const std::vector<Queued>& waits : inbox) stuck_.insert(stuck_.end(), waits.begin(), waits.end());
  }

  /// Four phases, one per colour. Returns the number of vertices inserted.
  std::uint64_t sweep(const Lattice& lattice, Inbox& inbox, const Deferral& later) {
    const auto start = std::chrono::steady_clock::now();
    Sweep done{lattice.columns(), lattice.rows()};
    for (unsigned colour = 0; colour < Lattice::colours && go_on(); ++colour) {
      std::vector<Job> jobs = jobs_of(lattice, colour, inbox);
      crew_.run(lattice, jobs, later, [this](int thread, std::uint64_t made) { return report(thread, made); });
      for (const Job& job : jobs) {
        for (const HandedOn& h : job.result.handed_on) inbox[h.cell].push_back(h.triangle);
        collect(job, done);
        if (&lattice == finest_) note_thread(job);
      }
      collect_deferred(jobs);
      triangles_before_ = crew_.triangles().in_use();
      vertices_before_ = crew_.vertices().in_use();
      made_ = 0;
      report(/*thread=*/0, 0);
    }
    done.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    counts_.tiling.sweeps.push_back(done);
    if (crew_.vertices().available() == 0) counts_.budget_reached = counts_.left_alone = true;
    if (Status fine = judge_sweep(done); !fine) {
      failure_ = fine.error();
      cancelled_ = true;
    }
    return done.inserted;
  }

  [[nodiscard]] Status judge_sweep(const Sweep& sweep) const {
    if (out_of_triangles()) return too_many_triangles();
    if (outgrows_memory(vertices_before_, options_)) return too_much_memory(options_);
    if (sweep.against_promise > 0) return promise_broken(sweep);
    if (!watcher_ || cancelled_.load()) return Done{};
    return watcher_(snapshot(t_, crew_.vertices(), crew_.triangles(), threads_), sweep);
  }

  void note_thread(const Job& job) {
    std::int16_t& thread = counts_.tiling.thread_of_cell[job.cell];
    if (thread < 0) thread = static_cast<std::int16_t>(job.thread);
  }

  /// A job for each cell of the colour in which something waits.
  [[nodiscard]] std::vector<Job> jobs_of(const Lattice& lattice, unsigned colour, Inbox& inbox) const {
    const std::vector<double> wanted = wanted_in_cells(inbox);
    std::vector<Job> jobs;
    for (Index cell = 0; cell < lattice.cells(); ++cell)
      if (lattice.colour_of(cell) == colour && !inbox[cell].empty()) {
        jobs.emplace_back();
        jobs.back().cell = cell;
        jobs.back().seeds = std::exchange(inbox[cell], {});
        jobs.back().insertions = insertions_per_triangle * lattice.sum_over_box(cell, wanted);
      }
    return jobs;
  }

  /// What the sizes ask for where the triangles lie that wait in each cell.
  [[nodiscard]] std::vector<double> wanted_in_cells(const Inbox& inbox) const {
    std::vector<double> wanted(inbox.size(), 0);
    if (!criteria_.has_size()) return wanted;
    parallel_for(threads_, inbox.size(), [&](std::size_t cell, int) {
      for (const Queued q : inbox[cell])
        if (judge_.is_current(q)) wanted[cell] += wanted_by(q.id(), Shape(t_, t_.slots[q.id()]));
    });
    return wanted;
  }

  void collect(const Job& job, Sweep& sweep) {
    const TaskResult& r = job.result;
    stuck_.insert(stuck_.end(), job.outsiders.begin(), job.outsiders.end());
    stuck_.insert(stuck_.end(), r.stuck.begin(), r.stuck.end());
    counts_.inserted += r.inserted;
    counts_.segment_splits += r.segment_splits;
    counts_.refused += r.refused;
    counts_.left_alone = counts_.left_alone || r.left_alone;
    sweep.inserted += r.inserted + r.segment_splits;
    sweep.to_other_cells += r.handed_on.size() - r.out_of_numbers;
    sweep.beyond_box += job.outsiders.size() + r.stuck.size();
    sweep.out_of_numbers += r.out_of_numbers;
    sweep.against_promise += r.against_promise + job.outsiders_against_promise;
  }

  void collect_deferred(const std::vector<Job>& jobs) {
    std::vector<std::span<const Deferred>> lists;
    for (const Job& job : jobs) lists.emplace_back(job.result.deferred);
    append_blocks(threads_, lists, deferred_);
  }

  Triangulation& t_;
  const Criteria& criteria_;
  const Options& options_;
  const Watcher& watcher_;
  Judge judge_;
  Crew crew_;
  int threads_;
  std::vector<Queued> stuck_;
  Array<Deferred> deferred_;
  RefineCounts counts_;
  const Lattice* finest_ = nullptr;  ///< once it is laid
  std::optional<Error> failure_;
  double estimate_ = 0;
  std::uint64_t triangles_before_ = 0, vertices_before_ = 0;  ///< when the last phase ended
  std::atomic<std::uint64_t> made_{0};                        ///< since then, as far as tasks have told
  std::uint64_t shown_ = 0;  ///< to the caller, so that it never sees fewer: a split on the rim makes but one
  std::atomic<bool> cancelled_{false};
};

}  // namespace

Result<RefineCounts> refine_by_sweeps(Triangulation& t, const DomainSegments& segments, const Criteria& criteria,
                                      const Options& options, const Schedule& schedule, const Watcher& watcher) {
  Refinement refinement(t, segments, criteria, options, schedule, watcher);
  if (Status done = refinement.run(); !done) return done.error();
  return std::move(refinement).counts();
}

}  // namespace pardel::engine
