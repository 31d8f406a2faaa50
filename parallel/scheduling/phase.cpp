#include "phase.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "../quality/estimates.hpp"
#include "../threads/parallel_for.hpp"
#include "communicator.hpp"

namespace pardel::engine {
namespace {

/// So many seeds are examined sooner by one thread than by several, which have to be woken.
constexpr std::size_t few_seeds = 10'000;

/// One vertex makes two triangles; a fifth is added as a reserve.
constexpr double insertions_per_triangle = 0.6;

Index most_vertices(const Triangulation& t, const Options& options) {
  const auto present = static_cast<std::uint64_t>(t.points.size());
  if (options.max_vertices == 0) return max_engine_triangles;
  return static_cast<Index>(
      std::clamp<std::uint64_t>(options.max_vertices, present, std::max<std::uint64_t>(present, max_engine_triangles)));
}

/// Estimates the largest number of points that can be inserted into an area to split the triangles that are not
/// deferred. Their circumradii are at least `apart`, and so are the distances between their circumcentres. Disks around
/// the circumcentres with half that radius are therefore disjoint.
double most_insertions(const Deferral& later, double area) {
  const double squared_apart = std::max(later.longest_squared / 4, later.squared_radius);
  return 4 / std::numbers::pi * area / squared_apart;
}

}  // namespace

void sort_by_place(const Triangulation& t, std::vector<QueuedTriangle>& triangles) {
  struct Placed {
    Point first_corner;  ///< most differ in it, so the other corners are seldom loaded
    QueuedTriangle triangle;
  };
  std::vector<Placed> placed;
  placed.reserve(triangles.size());
  for (const QueuedTriangle triangle : triangles) placed.push_back({t.points[triangle.first_corner], triangle});
  const auto other_corners = [&](QueuedTriangle triangle) {
    const auto& v = t.slots[triangle.id()].v;
    const Point b = t.points[v[1]], c = t.points[v[2]];
    return std::array{b.x, b.y, c.x, c.y};
  };
  std::ranges::sort(placed, [&](const Placed& a, const Placed& b) {
    if (a.first_corner.x != b.first_corner.x) return a.first_corner.x < b.first_corner.x;
    if (a.first_corner.y != b.first_corner.y) return a.first_corner.y < b.first_corner.y;
    return other_corners(a.triangle) < other_corners(b.triangle);
  });
  triangles.clear();
  for (const Placed& each : placed)
    if (triangles.empty() || triangles.back().id() != each.triangle.id()) triangles.push_back(each.triangle);
}

PhaseRunner::PhaseRunner(Triangulation& t, const Assessor& assessor, const Criteria& criteria, const Options& options,
                         const Threads& threads, const Schedule& schedule, Communicator& communicator)
    : t_(t),
      assessor_(assessor),
      criteria_(criteria),
      options_(options),
      schedule_(schedule),
      communicator_(communicator),
      threads_(threads),
      vertices_(static_cast<Index>(t.points.size()), most_vertices(t, options)),
      triangles_(static_cast<Index>(t.slots.size()), max_engine_triangles) {
  use(threads);
}

void PhaseRunner::use(const Threads& threads) {
  threads_ = threads;
  while (tasks_.size() < static_cast<std::size_t>(threads.count)) tasks_.push_back(new_task());
}

std::unique_ptr<Task> PhaseRunner::new_task() {
  const bool own_cell_only = is_of_the_paper(options_.decomposition);
  return std::make_unique<Task>(t_, assessor_, criteria_, options_.min_edge, own_cell_only);
}

std::vector<PlannedTask> PhaseRunner::plan(const Tiles& tiles, unsigned colour, const Deferrals& later,
                                           SeedsByCell& seeds) const {
  std::vector<double> wanted = triangles_wanted(seeds);
  std::vector<PlannedTask> tasks;
  for (Index cell = 0; cell < tiles.cells(); ++cell)
    if (tiles.colour_of(cell) == colour && !seeds[cell].empty()) {
      tasks.emplace_back();
      tasks.back().cell = cell;
      tasks.back().seeds = std::exchange(seeds[cell], {});
    }
  parallel_for(threads_, tasks.size(), [&](std::size_t i, int) { select_seeds(tasks[i], tiles); });
  communicator_.add_up_estimates(wanted);
  communicator_.deliver(tasks);
  for (PlannedTask& task : tasks) expect_insertions(task, tiles, later, wanted);
  return tasks;
}

/// Estimates the number of insertions, from the work in the box, and from the seeds.
void PhaseRunner::expect_insertions(PlannedTask& task, const Tiles& tiles, const Deferrals& later,
                                    const std::vector<double>& wanted) {
  if (task.elsewhere) return;
  constexpr double insertions_per_seed = 2.5, spare = 32;
  const double by_size = insertions_per_triangle * tiles.sum_over_box(task.cell, wanted);
  const double most = most_insertions(later.of(task.cell), tiles.box_area(task.cell));
  task.insertions = std::min(by_size, most) + spare + insertions_per_seed * static_cast<double>(task.seeds.size());
}

/// For each cell, the estimated number of triangles by which the bounds on size replace the seeds of the cell. The
/// order of the seeds does not change it.
std::vector<double> PhaseRunner::triangles_wanted(const SeedsByCell& seeds) const {
  std::vector<double> wanted(seeds.size(), 0);
  if (!criteria_.has_size()) return wanted;
  std::size_t all = 0;
  for (const std::vector<QueuedTriangle>& of_cell : seeds) all += of_cell.size();
  parallel_for(all > few_seeds ? threads_ : Threads(1, threads_.stop), seeds.size(), [&](std::size_t cell, int) {
    SparseAsk ask(threads_.stop);
    LocalHints hints;
    for (const QueuedTriangle seed : seeds[cell]) {
      ask();
      if (seed.is_current(t_))
        wanted[cell] +=
            estimate(criteria_.triangles_wanted(Shape(t_, t_.slots[seed.id()]), assessor_.region_of(seed.id()), hints));
    }
  });
  return wanted;
}

// The boxes of cells of one colour are disjoint (THEORY.md, Lattice and Quadtree), so the mesh is the same in whichever
// order the tasks take their steps (T-region).
void PhaseRunner::run(const Tiles& tiles, std::vector<PlannedTask>& tasks, const Deferrals& later,
                      const Task::Report& report) {
  assign_indices(tasks);
  t_.points.resize_uninitialised(vertices_.end());
  t_.origin.resize_uninitialised(vertices_.end());
  t_.slots.resize_uninitialised(triangles_.end());
  if (!t_.region.empty()) t_.region.resize_uninitialised(triangles_.end());

  if (schedule_.next)
    run_interleaved(tiles, tasks, later);
  else
    run_on_threads(tiles, tasks, later, report);
  if (schedule_.after_phase) schedule_.after_phase();

  for (const PlannedTask& task : tasks) {
    vertices_.release(task.free.vertices);
    triangles_.release(task.free.triangles);
  }
  vertices_.settle();
  triangles_.settle();
}

/// The test of Task::violates_t1 for a triangle that does not lie in the box of its cell. By theorem T1 the triangle
/// lies in the box if its split point lies in a face and in the cell, and its circumradius is small enough.
bool PhaseRunner::violates_t1(TriangleId id, Index cell, const Tiles& tiles) const {
  if (!is_of_the_paper(options_.decomposition)) return false;
  const double fits = tiles.radius_that_fits(cell);
  if (Shape(t_, t_.slots[id]).squared_circumradius() > fits * fits) return false;
  const Assessment a = assessor_.assess(id);
  return a.need == Assessment::Need::split_triangle && tiles.cell_of(assessor_.point_for(id, a)) == cell;
}

/// Keeps the seeds that are current and lie in the box, in the order of their places.
void PhaseRunner::select_seeds(PlannedTask& task, const Tiles& tiles) const {
  const Box box = tiles.box_of(task.cell);
  SparseAsk ask(threads_.stop);
  std::erase_if(task.seeds, [&](QueuedTriangle seed) {
    ask();
    if (!seed.is_current(t_)) return true;
    for (const VertexId v : t_.slots[seed.id()].v)
      if (!box.contains_half_open(t_.points[v])) {
        task.outside_box.push_back(seed);
        if (violates_t1(seed.id(), task.cell, tiles)) ++task.against_promise;
        return true;
      }
    return false;
  });
  sort_by_place(t_, task.seeds);
}

/// Each task first gets indices for the expected number of insertions and a quarter more. Each task then gets a second
/// part, above the first parts of all tasks, up to twice the expected number in total. The second part takes memory
/// only if a task uses it, but then it takes a huge page of each array. Unused indices are returned, and the next phase
/// uses them before it touches new memory.
void PhaseRunner::assign_indices(std::vector<PlannedTask>& tasks) {
  std::vector<std::vector<IndexRange>> vertices(tasks.size()), triangles(tasks.size());
  for (const bool first : {true, false})
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const auto expected = static_cast<std::size_t>(std::min(tasks[i].insertions, 1e9));
      const std::size_t insertions = first ? expected + expected / 4 : expected - expected / 4;
      vertices_.allocate(insertions, vertices[i]);
      triangles_.allocate(2 * insertions, triangles[i]);
    }
  for (std::size_t i = 0; i < tasks.size(); ++i)
    tasks[i].free = {IndexPool(std::move(vertices[i])), IndexPool(std::move(triangles[i]))};
}

void PhaseRunner::run_on_threads(const Tiles& tiles, std::vector<PlannedTask>& tasks, const Deferrals& later,
                                 const Task::Report& report) {
  std::vector<std::size_t> order(tasks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return tasks[a].insertions > tasks[b].insertions; });
  if (schedule_.order) schedule_.order(order);
  parallel_for(threads_, tasks.size(), [&](std::size_t i, int thread) {
    if (schedule_.before_task) schedule_.before_task(order[i]);
    PlannedTask& planned = tasks[order[i]];
    Task& task = *tasks_[static_cast<std::size_t>(thread)];
    planned.thread = thread;
    planned.result = task.run(tiles, planned.cell, planned.seeds, later.of(planned.cell), planned.free, report,
                              planned.lists_changes);
  });
}

void PhaseRunner::run_interleaved(const Tiles& tiles, std::vector<PlannedTask>& tasks, const Deferrals& later) {
  std::vector<std::unique_ptr<Task>> all;
  std::vector<std::size_t> unfinished;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    all.push_back(new_task());
    all[i]->start(tiles, tasks[i].cell, tasks[i].seeds, later.of(tasks[i].cell), tasks[i].free, {},
                  tasks[i].lists_changes);
    unfinished.push_back(i);
  }
  while (!unfinished.empty()) {
    const std::size_t turn = schedule_.next(unfinished.size());
    if (!all[unfinished[turn]]->step()) unfinished.erase(unfinished.begin() + static_cast<std::ptrdiff_t>(turn));
  }
  for (std::size_t i = 0; i < tasks.size(); ++i) tasks[i].result = all[i]->finish();
}

}  // namespace pardel::engine
