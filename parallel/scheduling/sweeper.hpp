// Sweeps over tiles, with what they need to know and what they find out.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "../decomposition/tiles.hpp"
#include "communicator.hpp"
#include "pending_triangles.hpp"
#include "phase.hpp"
#include "progress_monitor.hpp"
#include "refine_by_sweeps.hpp"
#include "tiling_record.hpp"

namespace pardel::engine {

/// What does not change during a refinement, and is the same in a gathered submesh.
struct RefinementJob {
  const Criteria& criteria;
  const Options& options;
  ProgressMonitor& progress;
  const Schedule& schedule;
  const Watcher& watcher;
};

/// From coarse tiles to fine ones. References to the elements stay valid when levels are added.
using Levels = std::deque<Tiles>;

/// Refines a triangulation by sweeps over one level of tiles after the other. Holds the triangles that wait for other
/// levels. Its functions throw Stopped if the run has to end.
class Sweeper {
 public:
  Sweeper(const RefinementJob& job, Triangulation& t, const DomainSegments& segments, const Threads& threads,
          Communicator& communicator);

  /// From now on, these threads work.
  void use(const Threads& threads);
  /// All vertices lie in this box, and will.
  void expect_within(const Box& bounds) { assessor_.expect_within(bounds); }
  /// The triangulation is a gathered submesh: lists the triangles that change, and what is missing.
  void begin_submesh(const Communicator::GatheredSubmesh& submesh);
  /// In a submesh: the triangles made, with repetitions. Uses up the list.
  [[nodiscard]] std::vector<TriangleId> take_changed() { return *std::move(changed_); }

  /// Puts triangles into the list of deferred ones, as assess_all() does.
  void defer_again(std::span<const QueuedTriangle> triangles);
  /// Splits the deferred triangles, except those that `later` defers again.
  void refine_due(const Tiles& tiles, const Deferrals& later);
  /// Splits, on each lattice, the triangles that are too long for the next finer one.
  void refine_coarse_levels(const Levels& levels);
  /// Splits the triangles whose cavities fit no box of a level, on the coarser levels, which have larger boxes. Also
  /// tries the blocked triangles again: a vertex may now lie between the split point of a triangle and the segment that
  /// blocked it. As long as this inserts vertices, it begins again with the triangles that still wait.
  void go_up(const Levels& levels);
  /// Replaces the counts of this rank by those of all ranks.
  void add_up_counts();

  [[nodiscard]] std::uint64_t made() const { return counts_.inserted + counts_.segment_splits; }
  [[nodiscard]] const Assessor& assessor() const { return assessor_; }
  [[nodiscard]] const Threads& threads() const { return threads_; }
  [[nodiscard]] PhaseRunner& runner() { return runner_; }
  [[nodiscard]] PendingTriangles& pending() { return pending_; }
  [[nodiscard]] TilingRecord& record() { return record_; }
  [[nodiscard]] RefineCounts& counts() { return counts_; }

 private:
  bool refine_waiting(const Levels& levels, std::size_t count);
  void sweep_to_fixpoint(const Tiles& tiles, SeedsByCell seeds, const Deferrals& later);
  std::uint64_t sweep(const Tiles& tiles, SeedsByCell& seeds, const Deferrals& later);
  void run_phase(const Tiles& tiles, unsigned colour, SeedsByCell& seeds, const Deferrals& later, Sweep& done);
  void collect(const PlannedTask& task, Sweep& sweep);
  void add_up(Sweep& sweep) const;
  [[nodiscard]] bool on_any_rank(bool here) const;
  [[nodiscard]] Status check_after(const Sweep& sweep) const;

  const RefinementJob& job_;
  Triangulation& t_;
  Communicator& communicator_;
  std::optional<std::vector<TriangleId>> changed_;  ///< in a submesh: the triangles made, with repetitions
  std::vector<VertexId>* needs_more_at_ = nullptr;  ///< of the submesh
  Assessor assessor_;
  Threads threads_;
  PhaseRunner runner_;
  PendingTriangles pending_;
  TilingRecord record_;
  RefineCounts counts_;
};

}  // namespace pardel::engine
