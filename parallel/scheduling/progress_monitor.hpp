// Counts the work of the tasks while they run, reports it to the caller, and stops the refinement.
#pragma once

#include <atomic>
#include <cstdint>

#include "../options.hpp"

namespace pardel::engine {

/// The progress of one refinement. It is cancelled by the caller (options.progress returns false), by cancel(), or when
/// the mesh outgrows options.max_memory.
class ProgressMonitor {
 public:
  explicit ProgressMonitor(const Options& options) : options_(options) {}

  /// `estimate`: the expected number of triangles of the final mesh, 0 if unknown.
  void start(double estimate, std::uint64_t vertices, std::uint64_t triangles);
  /// Replaces the counts of the running tasks by the exact numbers after a phase, and reports to the caller.
  void phase_ended(std::uint64_t vertices, std::uint64_t triangles);

  /// Tasks call this: `thread` has inserted `vertices_made` vertices since its last call. Returns false if the tasks
  /// have to end. Thread-safe. options.progress is called on thread 0 only, the thread that called the mesher.
  bool report(int thread, std::uint64_t vertices_made);

  void cancel() { cancelled_ = true; }
  [[nodiscard]] bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
  /// The number of vertices when the last phase ended.
  [[nodiscard]] std::uint64_t vertices() const { return vertices_; }

 private:
  const Options& options_;
  double estimate_ = 0;
  std::uint64_t vertices_ = 0, triangles_ = 0;  ///< when the last phase ended
  std::atomic<std::uint64_t> made_{0};          ///< triangles made since then, as far as tasks have reported them
  std::uint64_t shown_ = 0;                     ///< the number last shown to the caller
  std::atomic<bool> cancelled_{false};
};

}  // namespace pardel::engine
