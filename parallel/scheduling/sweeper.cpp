#include "sweeper.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "../../core/support/stopwatch.hpp"
#include "../triangulation/compact.hpp"
#include "../triangulation/limits.hpp"
#include "level_rules.hpp"

namespace pardel::engine {
namespace {

Error t1_violated(const Sweep& sweep) {
  return {ErrorKind::internal, "a self-check of the refinement failed: on " + std::to_string(sweep.columns) + " x " +
                                   std::to_string(sweep.rows) + " cells, " + std::to_string(sweep.against_promise) +
                                   " points did not fit the boxes of their cells, although all circumradii there are "
                                   "small enough (a quarter of the side of a cell, an eighth of that of a leaf)"};
}

}  // namespace

Sweeper::Sweeper(const RefinementJob& job, Triangulation& t, const DomainSegments& segments, const Threads& threads,
                 Communicator& communicator)
    : job_(job),
      t_(t),
      communicator_(communicator),
      assessor_(t, segments, job.criteria, job.options),
      threads_(threads),
      runner_(t, assessor_, job.criteria, job.options, threads_, job.schedule, communicator),
      pending_(t, assessor_, threads_) {}

void Sweeper::use(const Threads& threads) {
  threads_ = threads;
  runner_.use(threads);
  pending_.use(threads);
}

void Sweeper::begin_submesh(const Communicator::GatheredSubmesh& submesh) {
  changed_.emplace();
  needs_more_at_ = &submesh.needs_more_at;
  runner_.begin_submesh();
}

void Sweeper::defer_again(std::span<const QueuedTriangle> triangles) {
  Array<Deferred> bad;
  for (const QueuedTriangle triangle : triangles)
    if (const Assessment a = assessor_.assess(triangle.id()); a.need != Assessment::Need::nothing)
      bad.push_back({assessor_.entry(triangle.id(), a), a});
  pending_.defer(std::move(bad));
}

void Sweeper::refine_due(const Tiles& tiles, const Deferrals& later) {
  if (counts_.budget_reached) return;
  sweep_to_fixpoint(tiles, pending_.take_due_by_cell(tiles, later), later);
}

void Sweeper::refine_coarse_levels(const Levels& levels) {
  for (std::size_t level = 0; level + 1 < levels.size(); ++level)
    refine_due(levels[level], short_enough_for(*levels[level + 1].lattice(), job_.options.decomposition));
}

void Sweeper::go_up(const Levels& levels) {
  if (counts_.budget_reached) return;
  bool goes_on = refine_waiting(levels, levels.size() - 1) || levels.size() == 1;
  while (goes_on && pending_.any_needs_larger_box()) goes_on = refine_waiting(levels, levels.size());
}

/// Goes up through the `count` coarsest levels, from fine to coarse. Returns true if it has inserted vertices.
bool Sweeper::refine_waiting(const Levels& levels, std::size_t count) {
  const std::uint64_t before = made();
  for (std::size_t level = count; level-- > 0;)
    sweep_to_fixpoint(levels[level], pending_.take_needing_larger_box_by_cell(levels[level]), {});
  return made() > before;
}

void Sweeper::sweep_to_fixpoint(const Tiles& tiles, SeedsByCell seeds, const Deferrals& later) {
  const auto waiting = [&] {
    return !counts_.budget_reached &&
           on_any_rank(std::any_of(seeds.begin(), seeds.end(), [](const auto& of_cell) { return !of_cell.empty(); }));
  };
  // A triangle may need a point in one cell, then a point in another cell. Two tasks could hand it on to each other
  // for ever. After two sweeps without an insertion both have tried, and the triangle needs a larger box.
  for (int idle = 0; idle < 2 && waiting();) idle = sweep(tiles, seeds, later) > 0 ? 0 : idle + 1;
  for (const std::vector<QueuedTriangle>& of_cell : seeds) pending_.add_needing_larger_box(of_cell);
}

/// True if `here` is true on any rank.
bool Sweeper::on_any_rank(bool here) const {
  std::uint64_t ranks = here ? 1 : 0;
  communicator_.add_up({&ranks, 1});
  return ranks > 0;
}

/// Returns the number of vertices inserted.
std::uint64_t Sweeper::sweep(const Tiles& tiles, SeedsByCell& seeds, const Deferrals& later) {
  Stopwatch watch;
  Sweep done{tiles.columns(), tiles.rows()};
  for (unsigned colour = 0; colour < tiles.colours(); ++colour) {
    // Tasks could only hand their triangles on. Several ranks go through all phases together.
    if (communicator_.ranks() == 1 && runner_.vertices().available() == 0) break;
    run_phase(tiles, colour, seeds, later, done);
  }
  add_up(done);
  done.seconds = watch.seconds();
  record_.add_sweep(done);
  if (runner_.vertices().available() == 0) counts_.budget_reached = counts_.left_alone = true;
  if (Status fine = check_after(done); !fine) throw Stopped{fine.error()};
  return done.inserted;
}

void Sweeper::run_phase(const Tiles& tiles, unsigned colour, SeedsByCell& seeds, const Deferrals& later, Sweep& done) {
  std::vector<PlannedTask> tasks = runner_.plan(tiles, colour, later, seeds);
  if (changed_)
    for (PlannedTask& task : tasks) task.lists_changes = true;
  if (!tasks.empty()) runner_.run(tiles, tasks, later, [this](std::uint64_t made) { job_.progress.report(made); });
  communicator_.exchange_changes(tasks);
  for (const PlannedTask& task : tasks) {
    threads_.ask();
    if (changed_) changed_->insert(changed_->end(), task.result.changed.begin(), task.result.changed.end());
    for (const HandedOn& h : task.result.handed_on) seeds[h.cell].push_back(h.triangle);
    collect(task, done);
    if (!task.elsewhere) record_.add_task(tiles, task.cell, task.thread);
  }
  pending_.defer_all_of(tasks);
  job_.progress.phase_ended(runner_.vertices().in_use(), runner_.triangles().in_use());
}

/// Replaces the counts of this rank by those of all ranks.
void Sweeper::add_up(Sweep& sweep) const {
  std::array counts{sweep.inserted, sweep.to_other_cells, sweep.beyond_box, sweep.out_of_numbers,
                    sweep.against_promise};
  communicator_.add_up(counts);
  sweep.inserted = counts[0];
  sweep.to_other_cells = counts[1];
  sweep.beyond_box = counts[2];
  sweep.out_of_numbers = counts[3];
  sweep.against_promise = counts[4];
}

void Sweeper::add_up_counts() {
  std::array counts{counts_.inserted, counts_.segment_splits, counts_.refused, counts_.discarded};
  communicator_.add_up(counts);
  counts_.inserted = counts[0];
  counts_.segment_splits = counts[1];
  counts_.refused = counts[2];
  counts_.discarded = counts[3];
  counts_.left_alone = on_any_rank(counts_.left_alone);
}

Status Sweeper::check_after(const Sweep& sweep) const {
  if (runner_.triangles().available() < 2) return too_many_triangles();
  if (outgrows_memory(job_.progress.vertices(), job_.options)) return too_much_memory(job_.options);
  if (sweep.against_promise > 0) return t1_violated(sweep);
  if (!job_.watcher) return Done{};
  return job_.watcher(compacted_copy(t_, runner_.vertices(), runner_.triangles(), threads_), sweep);
}

void Sweeper::collect(const PlannedTask& task, Sweep& sweep) {
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

}  // namespace pardel::engine
