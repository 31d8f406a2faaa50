// One phase of a sweep: runs the tasks of all cells of one colour on all threads.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "../refinement/task.hpp"
#include "../threads/index_allocator.hpp"
#include "../threads/threads.hpp"

namespace pardel::engine {

/// Hooks into the execution of a phase. Tests use them to show that the mesh does not depend on the order. All hooks
/// are optional.
struct Schedule {
  /// Permutes the order in which the tasks are started. By default, the largest task comes first.
  std::function<void(std::vector<std::size_t>&)> order{};
  /// Called with the number of a task, by the thread that is about to start it.
  std::function<void(std::size_t task)> before_task{};
  std::function<void()> after_phase{};
  /// Interleaves the tasks: one thread runs all tasks of a phase together, one insertion at a time. Called before each
  /// insertion with the number n of unfinished tasks. Returns which of them, 0 to n - 1, makes the next insertion.
  std::function<std::size_t(std::size_t n)> next{};
};

/// A task of a phase. Before the phase: the cell and the triangles with which the task starts. Afterwards: its result.
struct PlannedTask {
  Index cell = 0;
  double insertions = 0;  ///< the expected number of insertions
  std::vector<QueuedTriangle> seeds;
  std::vector<QueuedTriangle> outside_box;  ///< seeds that the task did not get, because not all corners lie in the box
  std::uint64_t against_promise = 0;        ///< how many of outside_box should lie in the box by theorem T1
  bool elsewhere = false;                   ///< the seeds were sent to another rank, which runs the task
  bool lists_changes = false;               ///< the result has to list the changed triangles
  FreeIndices free;
  TaskResult result;
  int thread = 0;  ///< the thread that ran the task
};

/// For each cell, the triangles with which the cell's next task starts (seeds).
using SeedsByCell = std::vector<std::vector<QueuedTriangle>>;

class Communicator;

/// Sorts triangles by the coordinates of their corners, and removes those that occur twice. The tasks and passes before
/// a task determine which triangles it starts with. The order in which they found them must not matter.
void sort_by_place(const Triangulation& t, std::vector<QueuedTriangle>& triangles);

/// Runs phases. Owns the allocators of vertex and triangle indices, and one Task per thread.
class PhaseRunner {
 public:
  PhaseRunner(Triangulation& t, const Assessor& assessor, const Criteria& criteria, const Options& options,
              const Threads& threads, const Schedule& schedule, Communicator& communicator);

  /// From now on, these threads work.
  void use(const Threads& threads);
  /// See Task::begin_submesh().
  void begin_submesh() {
    for (const std::unique_ptr<Task>& task : tasks_) task->begin_submesh();
  }

  /// Plans one task for each cell of the colour that has seeds. Moves the seeds that are current and lie in the box
  /// into the tasks. Collective.
  [[nodiscard]] std::vector<PlannedTask> plan(const Tiles& tiles, unsigned colour, const Deferrals& later,
                                              SeedsByCell& seeds) const;

  /// Runs the tasks. Each calls `report` from time to time. Precondition: their cells have one colour, so that their
  /// boxes are disjoint.
  void run(const Tiles& tiles, std::vector<PlannedTask>& tasks, const Deferrals& later, const Task::Report& report);

  [[nodiscard]] const IndexAllocator& vertices() const { return vertices_; }
  [[nodiscard]] const IndexAllocator& triangles() const { return triangles_; }
  /// For new vertices and triangles that do not come from a task.
  [[nodiscard]] IndexAllocator& vertices() { return vertices_; }
  [[nodiscard]] IndexAllocator& triangles() { return triangles_; }

 private:
  [[nodiscard]] std::vector<double> triangles_wanted(const SeedsByCell& seeds) const;
  void select_seeds(PlannedTask& task, const Tiles& tiles) const;
  static void expect_insertions(PlannedTask& task, const Tiles& tiles, const Deferrals& later,
                                const std::vector<double>& wanted);
  [[nodiscard]] bool violates_t1(TriangleId id, Index cell, const Tiles& tiles) const;
  void assign_indices(std::vector<PlannedTask>& tasks);
  void run_on_threads(const Tiles& tiles, std::vector<PlannedTask>& tasks, const Deferrals& later,
                      const Task::Report& report);
  void run_interleaved(const Tiles& tiles, std::vector<PlannedTask>& tasks, const Deferrals& later);
  [[nodiscard]] std::unique_ptr<Task> new_task();

  Triangulation& t_;
  const Assessor& assessor_;
  const Criteria& criteria_;
  const Options& options_;
  const Schedule& schedule_;
  Communicator& communicator_;
  Threads threads_;
  std::vector<std::unique_ptr<Task>> tasks_;  ///< one per thread
  IndexAllocator vertices_, triangles_;
};

}  // namespace pardel::engine
