#include "phase.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "../concurrency/parallel_for.hpp"

namespace pardel::engine {
namespace {

Index most_vertices(const Triangulation& t, const Options& options) {
  const auto present = static_cast<std::uint64_t>(t.points.size());
  if (options.max_vertices == 0) return max_engine_triangles;
  return static_cast<Index>(
      std::clamp<std::uint64_t>(options.max_vertices, present, std::max<std::uint64_t>(present, max_engine_triangles)));
}

/// About how many points go into an area for the sake of triangles that are not deferred: their circumradii are at
/// least `apart`, and so are the distances between circumcentres, about which disks of half that radius are disjoint.
double most_insertions(const Deferral& later, double area) {
  const double squared_apart = std::max(later.longest_squared / 4, later.squared_radius);
  return 4 / std::numbers::pi * area / squared_apart;
}

}  // namespace

Crew::Crew(Triangulation& t, const Judge& judge, const Criteria& criteria, const Options& options,
           const Schedule& schedule)
    : t_(t),
      judge_(judge),
      criteria_(criteria),
      options_(options),
      schedule_(schedule),
      threads_(std::max(1, options.threads)),
      vertices_(static_cast<Index>(t.points.size()), most_vertices(t, options)),
      triangles_(static_cast<Index>(t.slots.size()), max_engine_triangles) {
  for (int i = 0; i < threads_; ++i) tasks_.push_back(new_task());
}

std::unique_ptr<Task> Crew::new_task() {
  const bool own_cell_only = options_.decomposition == Decomposition::paper;
  return std::make_unique<Task>(t_, judge_, criteria_, options_.min_edge, own_cell_only);
}

void Crew::run(const Lattice& lattice, std::vector<Job>& jobs, const Deferral& later,
               const std::function<bool(int, std::uint64_t)>& go_on) {
  const double most = most_insertions(later, 4 * lattice.width() * lattice.height());
  parallel_for(threads_, jobs.size(), [&](std::size_t i, int) {
    jobs[i].insertions = std::min(jobs[i].insertions, most);
    admit(jobs[i], lattice);
  });
  supply(jobs);
  t_.points.resize_uninitialised(vertices_.end());
  t_.origin.resize_uninitialised(vertices_.end());
  t_.slots.resize_uninitialised(triangles_.end());
  if (!t_.region.empty()) t_.region.resize_uninitialised(triangles_.end());

  if (schedule_.next)
    run_by_turns(lattice, jobs, later);
  else
    run_on_threads(lattice, jobs, later, go_on);
  if (schedule_.after_phase) schedule_.after_phase();

  for (const Job& job : jobs) {
    vertices_.take_back(job.supply.vertices);
    triangles_.take_back(job.supply.triangles);
  }
  vertices_.settle();
  triangles_.settle();
}

/// As for a task: a triangle that asks for a point in a face, in the cell, does not lie in the box, though T1 says so.
bool Crew::breaks_promise(TriangleId id, Index cell, const Lattice& lattice) const {
  const double fits = lattice.radius_that_fits();
  if (options_.decomposition != Decomposition::paper || Shape(t_, t_.slots[id]).squared_circumradius() > fits * fits)
    return false;
  const Assessment a = judge_.assess(id);
  return a.need == Assessment::Need::split_triangle && lattice.cell_of(judge_.point_for(id, a)) == cell;
}

/// Keeps the seeds that are still there and whose triangles lie in the box.
void Crew::admit(Job& job, const Lattice& lattice) const {
  const Box box = lattice.box_of(job.cell);
  constexpr double insertions_per_seed = 2.5, spare = 32;
  job.insertions += spare;
  std::erase_if(job.seeds, [&](Queued q) {
    if (!judge_.is_current(q)) return true;
    for (const VertexId v : t_.slots[q.id()].v)
      if (!box.contains_half_open(t_.points[v])) {
        job.outsiders.push_back(q);
        if (breaks_promise(q.id(), job.cell, lattice)) ++job.outsiders_against_promise;
        return true;
      }
    job.insertions += insertions_per_seed;
    return false;
  });
}

/// Numbers for each job: what it is expected to need and a quarter more; then, above all of these, up to twice of what
/// is expected. The second helping costs memory only where it is needed, but there a huge page for each array. What is
/// not used comes back, and the next phase fills it before it takes memory that nobody has written yet.
void Crew::supply(std::vector<Job>& jobs) {
  std::vector<std::vector<IndexRange>> vertices(jobs.size()), triangles(jobs.size());
  for (const bool first : {true, false})
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      const auto expected = static_cast<std::size_t>(std::min(jobs[i].insertions, 1e9));
      const std::size_t insertions = first ? expected + expected / 4 : expected - expected / 4;
      vertices_.assign(insertions, vertices[i]);
      triangles_.assign(2 * insertions, triangles[i]);
    }
  for (std::size_t i = 0; i < jobs.size(); ++i)
    jobs[i].supply = {IndexPool(std::move(vertices[i])), IndexPool(std::move(triangles[i]))};
}

void Crew::run_on_threads(const Lattice& lattice, std::vector<Job>& jobs, const Deferral& later,
                          const std::function<bool(int, std::uint64_t)>& go_on) {
  std::vector<std::size_t> order(jobs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return jobs[a].insertions > jobs[b].insertions; });
  if (schedule_.order) schedule_.order(order);
  parallel_for(threads_, jobs.size(), [&](std::size_t i, int thread) {
    if (schedule_.before_task) schedule_.before_task(order[i]);
    Job& job = jobs[order[i]];
    Task& task = *tasks_[static_cast<std::size_t>(thread)];
    job.thread = thread;
    job.result = task.run(lattice, job.cell, job.seeds, later, job.supply,
                          [&](std::uint64_t made) { return go_on(thread, made); });
  });
}

void Crew::run_by_turns(const Lattice& lattice, std::vector<Job>& jobs, const Deferral& later) {
  std::vector<std::unique_ptr<Task>> all;
  std::vector<std::size_t> unfinished;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    all.push_back(new_task());
    all[i]->start(lattice, jobs[i].cell, jobs[i].seeds, later, jobs[i].supply);
    unfinished.push_back(i);
  }
  while (!unfinished.empty()) {
    const std::size_t turn = schedule_.next(unfinished.size());
    if (!all[unfinished[turn]]->step()) unfinished.erase(unfinished.begin() + static_cast<std::ptrdiff_t>(turn));
  }
  for (std::size_t i = 0; i < jobs.size(); ++i) jobs[i].result = all[i]->finish();
}

}  // namespace pardel::engine
