#include "trace.hpp"

#include <algorithm>
#include <utility>

#include "../../core/support/stop_signal.hpp"
#include "../../distributed/meshing/piece.hpp"
#include "../../parallel/diagnosis/find_gaps.hpp"
#include "../../parallel/planning/run_plan.hpp"
#include "../../parallel/planning/supervised.hpp"
#include "../../parallel/scheduling/refine_domain.hpp"
#include "../../parallel/threads/parallel_for.hpp"
#include "../../parallel/triangulation/compact.hpp"
#include "thread_time.hpp"

namespace pardel::bench {

using namespace engine;

namespace {

class OneRank : public Ranks {
 public:
  [[nodiscard]] int rank() const override { return 0; }
  [[nodiscard]] int count() const override { return 1; }
  [[nodiscard]] std::vector<Bytes> exchange(std::vector<Bytes> messages) override { return messages; }
  void add_up(std::span<std::uint64_t> /*values*/) override {}
};

/// Thrown when the coarse levels are done and nothing else is wanted.
struct CoarseIsEnough {};

/// Measures the tasks of a phase. The hooks do not change the result.
class TaskTimes {
 public:
  [[nodiscard]] Schedule hooks() {
    Schedule schedule;
    schedule.before_task = [this](std::size_t task) {
      end_task();
      task_ = task;
    };
    schedule.after_phase = [this] { end_task(); };
    return schedule;
  }
  /// The seconds of each task since the last call.
  [[nodiscard]] std::vector<double> take(std::size_t tasks) {
    std::vector<double> taken = std::exchange(seconds_, {});
    taken.resize(tasks, 0);
    return taken;
  }

 private:
  static constexpr std::size_t none = SIZE_MAX;
  void end_task() {
    const double seconds = watch_.lap();
    if (task_ == none) return;
    if (seconds_.size() <= task_) seconds_.resize(task_ + 1, 0);
    seconds_[std::exchange(task_, none)] = seconds;
  }
  ThreadWatch watch_;
  std::size_t task_ = none;
  std::vector<double> seconds_;
};

/// The distribution of a run by one rank, which replays each step for all numbers of ranks.
class TracedDistribution : public Distribution {
 public:
  TracedDistribution(Ranks& one, Triangulation& t, const Problem& problem, const std::vector<int>& ranks, Extent extent,
                     TaskTimes& times, Trace& trace)
      : Distribution(one, t, problem.input_of_vertex, problem.input_markers),
        t_(t),
        problem_(problem),
        ranks_(ranks),
        extent_(extent),
        times_(times),
        trace_(trace) {}

  void divide_by(const Tiles& tiles, std::span<const double> work, PhaseRunner& runner) override {
    trace_.before_seconds = watch_.lap();
    trace_.coarse_triangles = runner.triangles().in_use();
    trace_.promised.assign(work.begin(), work.end());
    trace_.tiles = std::make_shared<Tiles>(tiles);
    {
      const Triangulation copy = compacted_copy(t_, runner.vertices(), runner.triangles(), Threads(1));
      trace_.messages = measure_messages(copy);
      for (const int count : ranks_)
        trace_.for_ranks.push_back({Replay(tiles, work, count), measure_lone_rank(copy, tiles, work, problem_, count)});
    }
    if (extent_ == Extent::coarse) throw CoarseIsEnough{};
    Distribution::divide_by(tiles, work, runner);
    cell_with_.assign(t_.slots.size(), no_index);
    watch_.lap();
  }

  /// How many ranks have room for the triangles.
  [[nodiscard]] int ranks() const override { return extent_ == Extent::coarse ? std::ranges::max(ranks_) : 1; }

  void add_up(std::span<std::uint64_t> values) override {
    if (!is_in_parts()) return;
    outside_tasks_ += watch_.lap();
    for (ForRanks& each : trace_.for_ranks) each.replay.sum(values.size());
    watch_.lap();
  }

  void deliver(std::vector<PlannedTask>& tasks) override {
    if (!is_in_parts()) return;
    outside_tasks_ += watch_.lap();
    const auto cell_with = [this](QueuedTriangle seed) {
      const Index cell = seed.id() < cell_with_.size() ? cell_with_[seed.id()] : no_index;
      return cell != no_index ? cell : cell_of(t_.slots[seed.id()].v[0]);
    };
    replay([&](Replay& each) { each.deliver(tasks, cell_with); });
    watch_.lap();
    Distribution::deliver(tasks);
    for (PlannedTask& task : tasks) task.lists_changes = true;
    (void)times_.take(0);
  }

  void exchange_changes(std::vector<PlannedTask>& tasks) override {
    if (!is_in_parts()) return;
    outside_tasks_ += watch_.lap();
    std::vector<double> seconds = times_.take(tasks.size());
    PhaseRecord& phase = trace_.phases.emplace_back();
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const TaskResult& result = tasks[i].result;
      phase.push_back({tasks[i].cell, seconds[i], result.inserted + result.segment_splits});
      outside_tasks_ -= seconds[i];
      note_owners(tasks[i]);
    }
    share_outside(phase);
    for (std::size_t i = 0; i < tasks.size(); ++i) seconds[i] = phase[i].seconds;
    replay([&](Replay& each) { each.exchange_changes(tasks, seconds, t_, part().common().triangles); });
    watch_.lap();
    Distribution::exchange_changes(tasks);
  }

  void refine_rest(const RestOfWork& work) override {
    RestOfWork counted = work;
    counted.take_rest = [&] {
      std::vector<QueuedTriangle> rest = work.take_rest();
      trace_.rest = rest.size();
      return rest;
    };
    for (ForRanks& each : trace_.for_ranks) each.replay.sum(1);
    Distribution::refine_rest(counted);
    watch_.lap();
  }

  void finish(Triangulation& t, const PhaseRunner& runner, const Threads& threads) override {
    Distribution::finish(t, runner, threads);
    watch_.lap();
  }

  /// The processor time since finish(), or since the last call.
  [[nodiscard]] double seconds_since_finish() { return watch_.lap(); }
  /// The replays make their pieces.
  void replay_pieces() {
    part().for_each_triangle([&](TriangleId) { ++trace_.triangles; });
    std::vector<Index> inserter(t_.points.size(), no_index);
    for (const Insertions& each : insertions())
      std::fill(inserter.begin() + each.vertices.begin, inserter.begin() + each.vertices.end, each.cell);
    replay([&](Replay& each) { each.finish(t_, part(), inserter); });
    watch_.lap();
  }

 private:
  template <class Work>
  void replay(const Work& work) {
    parallel_for(Threads(thread_count(0)), trace_.for_ranks.size(),
                 [&](std::size_t i, int) { work(trace_.for_ranks[i].replay); });
  }

  /// The triangles that a task leaves to later ones stay on its rank until their cells' tasks start.
  void note_owners(const PlannedTask& task) {
    if (cell_with_.size() < t_.slots.size()) cell_with_.resize(t_.slots.size(), no_index);
    for (const HandedOn& h : task.result.handed_on) cell_with_[h.triangle.id()] = task.cell;
    for (const Deferred& d : task.result.deferred) cell_with_[d.triangle.id()] = task.cell;
  }

  /// A phase takes some time even without tasks (RankCosts::phase). The rest of the time outside the tasks is for
  /// seeds, indices and results: it counts as a part of the tasks.
  void share_outside(PhaseRecord& phase) {
    const double shared = outside_tasks_ - trace_.for_ranks.front().alone.phase_seconds;
    outside_tasks_ = 0;
    double in_tasks = 0;
    for (const TaskRecord& task : phase) in_tasks += task.seconds;
    if (in_tasks <= 0 || shared <= 0) return;
    for (TaskRecord& task : phase) task.seconds *= 1 + shared / in_tasks;
  }

  Triangulation& t_;
  Problem problem_;
  const std::vector<int>& ranks_;
  Extent extent_;
  TaskTimes& times_;
  Trace& trace_;
  ThreadWatch watch_;
  double outside_tasks_ = 0;
  std::vector<Index> cell_with_;  ///< per slot: the cell whose task has left the triangle to later ones, or no_index
};

/// The steps of mesh_in_ranks() (distributed/meshing/mesh_in_ranks.cpp), measured.
Result<Trace> traced(const ValidPslg& valid, const Goal& goal, const Options& options, ProgressMonitor& progress,
                     const std::vector<int>& ranks, Extent extent) {
  Trace trace;
  const Pslg& pslg = valid.pslg();
  const Threads threads = progress.threads();
  ThreadWatch watch;
  Result<DomainTriangulation> domain = triangulate_domain(pslg, valid.convex_hull() || goal.convex_hull, threads);
  if (!domain) return domain.error();
  Report report;
  InputData input = input_data(pslg, *domain, threads);
  report.gaps = find_gaps(*domain, threads);
  const Result<RunPlan> plan = plan_run(pslg, goal, *domain, options, threads);
  if (!plan) return plan.error();
  const double planned = watch.lap();

  OneRank one;
  TaskTimes times;
  TracedDistribution distribution(
      one, domain->triangulation,
      {domain->segments, plan->criteria, options, domain->input_of_vertex.span(), input.points.markers}, ranks, extent,
      times, trace);
  try {
    Result<RefineCounts> counts = refine_by_sweeps(domain->triangulation, domain->segments, plan->criteria, options,
                                                   progress, times.hooks(), {}, distribution);
    if (!counts) return counts.error();
    trace.before_seconds += planned;
    write_report(*domain, plan->criteria, options, std::move(*counts), threads, report,
                 [&](TriangleId id) { return distribution.part().has(id); });
  } catch (const CoarseIsEnough&) {
    trace.before_seconds += planned;
    return trace;
  }
  const double reported = distribution.seconds_since_finish();
  distribution.replay_pieces();
  static_cast<void>(make_piece(*domain, distribution, std::move(input), report.exempt, threads));
  trace.piece_seconds = reported + distribution.seconds_since_finish();
  for (ForRanks& each : trace.for_ranks) each.replay.set_piece_seconds(trace.piece_seconds);
  return trace;
}

}  // namespace

Result<Trace> trace(const ValidPslg& domain, const Goal& goal, const Options& options, const std::vector<int>& ranks,
                    Extent extent) {
  Options one_thread = options;
  one_thread.threads = 1;
  return supervised(one_thread, [&](const Options& safe, ProgressMonitor& progress) {
    return traced(domain, goal, safe, progress, ranks, extent);
  });
}

}  // namespace pardel::bench
