// One phase of a sweep: runs the tasks of all cells of one colour on all threads.
#pragma once

#include <memory>
#include <vector>

#include "../concurrency/index_allocator.hpp"
#include "../concurrency/threads.hpp"
#include "../refinement/task.hpp"
#include "schedule.hpp"

namespace pardel::engine {

/// A task of a phase. Before the phase: the cell and the triangles with which the task starts. Afterwards: its result.
struct PlannedTask {
  Index cell = 0;
  double insertions = 0;  ///< the expected number of insertions
  std::vector<QueuedTriangle> seeds;
  std::vector<QueuedTriangle> outside_box;  ///< seeds that the task did not get, because not all corners lie in the box
  std::uint64_t t1_violations = 0;          ///< how many of outside_box should lie in the box by theorem T1
  FreeIndices free;
  TaskResult result;
  int thread = 0;  ///< the thread that ran the task
};

/// For each cell, the triangles with which the cell's next task starts (seeds).
using SeedsByCell = std::vector<std::vector<QueuedTriangle>>;

/// Runs phases. Owns the allocators of vertex and triangle indices, and one Task per thread.
class PhaseRunner {
 public:
  PhaseRunner(Triangulation& t, const Assessor& assessor, const Criteria& criteria, const Options& options,
              const Threads& threads, const Schedule& schedule);

  /// Plans one task for each cell of the colour that has seeds. Moves the seeds into the tasks.
  [[nodiscard]] std::vector<PlannedTask> plan(const Tiles& tiles, unsigned colour, SeedsByCell& seeds) const;

  /// Runs the tasks. Each calls `report` from time to time. Precondition: their cells have one colour, so that their
  /// boxes are disjoint.
  void run(const Tiles& tiles, std::vector<PlannedTask>& tasks, const Deferrals& later, const Task::Report& report);

  [[nodiscard]] const IndexAllocator& vertices() const { return vertices_; }
  [[nodiscard]] const IndexAllocator& triangles() const { return triangles_; }

 private:
  [[nodiscard]] std::vector<double> triangles_wanted(const SeedsByCell& seeds) const;
  void select_seeds(PlannedTask& task, const Tiles& tiles) const;
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
  Threads threads_;
  std::vector<std::unique_ptr<Task>> tasks_;  ///< one per thread
  IndexAllocator vertices_, triangles_;
};

}  // namespace pardel::engine
