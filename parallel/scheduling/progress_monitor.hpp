// Counts the work of a run, reports it to the caller, and ends the run at the caller's request or at its limits.
#pragma once

#include <atomic>
#include <cmath>
#include <cstdint>

#include "../options.hpp"
#include "../threads/threads.hpp"

namespace pardel::engine {

/// The progress of one run, from the validation to the export. The run ends if options.progress returns false, if the
/// mesh outgrows options.max_memory, or if a caller stops the signal of threads().
class ProgressMonitor {
 public:
  /// interval: the time between two calls of options.progress.
  explicit ProgressMonitor(const Options& options, StopSignal::Clock::duration interval = StopSignal::usual_interval);

  /// The threads of the run: options.threads, or as many as pay for the present work. Their loops call
  /// options.progress; only the thread that made the monitor calls it.
  [[nodiscard]] Threads threads();
  /// From now on, the work is this number of points or triangles. Before the first call, it is not known to be small.
  void expect(double work) { work_ = work; }

  /// Counts vertices and triangles that will be added to the mesh after the refinement, until the next call.
  void set_aside(std::uint64_t vertices, std::uint64_t triangles);
  [[nodiscard]] std::uint64_t triangles_aside() const { return triangles_aside_; }
  /// Starts the refinement. `estimate`: the expected number of triangles of the final mesh, 0 if unknown.
  void start(double estimate, std::uint64_t vertices, std::uint64_t triangles);
  /// Tasks call this: they have inserted `vertices_made` vertices since the last call. Throws Stopped if the run has to
  /// end. Thread-safe.
  void report(std::uint64_t vertices_made);
  /// Replaces the counts of the running tasks by the exact numbers after a phase, and reports to the caller. Throws
  /// Stopped if the run has to end.
  void phase_ended(std::uint64_t vertices, std::uint64_t triangles);

  /// The number of vertices when the last phase ended, with those set aside.
  [[nodiscard]] std::uint64_t vertices() const { return vertices_; }

 private:
  [[nodiscard]] std::optional<Error> ask_caller();

  const Options& options_;
  StopSignal stop_;
  double work_ = INFINITY;
  double estimate_ = 0;
  std::uint64_t vertices_aside_ = 0, triangles_aside_ = 0;
  std::uint64_t vertices_ = 0, triangles_ = 0;  ///< when the last phase ended, with those set aside
  std::atomic<std::uint64_t> made_{0};          ///< triangles made since then, as far as tasks have reported them
  std::uint64_t shown_ = 0;                     ///< the number last shown to the caller
};

}  // namespace pardel::engine
