// One phase of a sweep: the tasks of all cells of one colour, on all threads.
#pragma once

#include <memory>
#include <vector>

#include "../concurrency/index_allocator.hpp"
#include "../refinement/task.hpp"
#include "refine_by_sweeps.hpp"

namespace pardel::engine {

/// A task to be: a cell with what waits for it, and afterwards what the task did.
struct Job {
  Index cell = 0;
  double insertions = 0;  ///< expected
  std::vector<Queued> seeds;
  std::vector<Queued> outsiders;                ///< seeds whose triangles do not lie in the box
  std::uint64_t outsiders_against_promise = 0;  ///< how many of them should
  Supply supply;
  TaskResult result;
  int thread = 0;  ///< that ran it
};

/// Who may use which numbers, and who works: one task per thread.
class Crew {
 public:
  Crew(Triangulation& t, const Judge& judge, const Criteria& criteria, const Options& options,
       const Schedule& schedule);

  /// Runs the jobs, whose cells have one colour, so that their boxes are disjoint. go_on(thread, n) is asked now and
  /// then, n being the number of vertices that the thread has inserted since it was asked last.
  void run(const Lattice& lattice, std::vector<Job>& jobs, const Deferral& later,
           const std::function<bool(int, std::uint64_t)>& go_on);

  [[nodiscard]] const IndexAllocator& vertices() const { return vertices_; }
  [[nodiscard]] const IndexAllocator& triangles() const { return triangles_; }
  [[nodiscard]] int threads() const { return threads_; }

 private:
  void admit(Job& job, const Lattice& lattice) const;
  [[nodiscard]] bool breaks_promise(TriangleId id, Index cell, const Lattice& lattice) const;
  void supply(std::vector<Job>& jobs);
  void run_on_threads(const Lattice& lattice, std::vector<Job>& jobs, const Deferral& later,
                      const std::function<bool(int, std::uint64_t)>& go_on);
  void run_by_turns(const Lattice& lattice, std::vector<Job>& jobs, const Deferral& later);
  [[nodiscard]] std::unique_ptr<Task> new_task();

  Triangulation& t_;
  const Judge& judge_;
  const Criteria& criteria_;
  const Options& options_;
  const Schedule& schedule_;
  int threads_;
  std::vector<std::unique_ptr<Task>> tasks_;
  IndexAllocator vertices_, triangles_;
};

}  // namespace pardel::engine
