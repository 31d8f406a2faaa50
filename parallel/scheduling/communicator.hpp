// The communicator: what a refinement shares with the other ranks of a run.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "../decomposition/tiles.hpp"
#include "phase.hpp"
#include "waiting.hpp"

namespace pardel::engine {

class PendingTriangles;
struct RefineCounts;

/// Connects the refinement of this rank with that of the other ranks (ranks.hpp). OneProcess (one_process.hpp) is the
/// communicator of a run without other ranks.
///
/// A run on ranks begins in one of two ways. Either all ranks have the same mesh. Then every rank refines the coarse
/// levels alike, until divide(), and until then nothing has to be exchanged. Or the mesh begins in parts, and no rank
/// ever has all of it. Then one rank refines the coarse levels, in a gathered submesh. After divide(), every rank runs
/// the tasks of the cells that it owns, on the part of the mesh around them, and the ranks exchange what they changed
/// after every phase.
///
/// All functions but counted() and ranks() are collective. They throw Stopped if the run has to end.
class Communicator {
 public:
  Communicator() = default;
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;
  virtual ~Communicator() = default;

  /// The number of ranks.
  [[nodiscard]] virtual int ranks() const = 0;

  // Values. What all ranks have alike stays as it is.
  virtual void add_up(std::span<std::uint64_t> values) = 0;
  /// Replaces estimates of triangles by their sums over all ranks.
  virtual void add_up_estimates(std::span<double> estimates) = 0;
  /// Replaces each value by the largest one of all ranks.
  virtual void take_largest(std::span<double> values) = 0;
  [[nodiscard]] virtual Box bounds_of_all(const Box& here) = 0;

  /// To be called first. The indices of all vertices and triangles are in use.
  virtual void begin(PhaseRunner& runner) = 0;
  /// After begin(): the triangles that are counted on this rank, of those with an index. Empty: all.
  [[nodiscard]] virtual std::function<bool(TriangleId)> counted() const = 0;

  /// A gathered submesh: triangles of all ranks around some of them, on one rank.
  struct GatheredSubmesh {
    std::vector<QueuedTriangle> first;  ///< with which its refinement starts
    Triangulation& t;
    /// The segments that its triangles lie on; nullptr if all ranks have all segments.
    const DomainSegments* segments;
    /// To be filled if the submesh is too small: vertices around which more triangles are needed. Then the result does
    /// not count.
    std::vector<VertexId>& needs_more_at;
  };
  /// Refines a submesh. Returns the changed triangles. Throws NotHeld if the submesh is too small at a place that
  /// is not known.
  using RefineSubmesh = std::function<std::vector<TriangleId>(const GatheredSubmesh& submesh)>;

  /// The refinement on the coarse levels: of the mesh of this rank, or of a submesh.
  struct CoarseWork {
    std::function<void()> refine_here;
    /// The triangles of this rank that coarse levels have to split.
    std::function<std::vector<Deferred>()> take_due;
    /// Refines a submesh. Returns what waits there for finer levels, or for a larger box.
    std::function<Waiting(const GatheredSubmesh& submesh, std::vector<TriangleId>& changed)> refine_submesh;
  };
  /// Refines the coarse levels: on every rank, if all have the same mesh. Otherwise one rank gets the due triangles and
  /// those around them; if this submesh is too small, it gets more and starts again. All ranks take over the changes.
  /// Returns what now waits on this rank in addition.
  [[nodiscard]] virtual Waiting refine_coarse(const CoarseWork& work) = 0;

  struct Division {
    const Tiles& finest;
    std::function<std::vector<double>()> work_of_cells;
    PendingTriangles& pending;  ///< afterwards, each triangle waits on one rank
    RefineCounts& counts;       ///< afterwards, their sum over all ranks is that of what has been done
  };
  /// Divides the finest tiles among the ranks, by the work in their cells. Removes from the mesh what this rank need
  /// not hold, and gets from other ranks what it has to hold.
  virtual void divide(const Division& division, PhaseRunner& runner) = 0;

  /// Sends the seeds of tasks whose cells belong to other ranks to these ranks, and marks the tasks as `elsewhere`.
  /// Adds the seeds that arrive to the tasks of this rank, in the order of cells. Decides which tasks list changes.
  virtual void deliver(std::vector<PlannedTask>& tasks) = 0;
  /// Tells the ranks that hold them about the triangles that the tasks have changed. Uses up the lists of changes.
  virtual void exchange_changes(std::vector<PlannedTask>& tasks) = 0;

  /// The refinement of the triangles whose cavities fit no box of the finest tiles, and of those that were blocked
  /// (TaskResult::blocked): in the mesh of this rank, or in a submesh.
  struct RestOfWork {
    std::function<void()> refine_here;
    std::function<std::vector<QueuedTriangle>()> take_rest;
    RefineSubmesh refine_submesh;
  };
  /// Does the rest of the work. The triangles are few, unless many segments may not be split. If the mesh is divided,
  /// one rank gets the triangles near them; if this submesh is too small, it gets more and starts again. All ranks then
  /// take over the changes.
  virtual void refine_rest(const RestOfWork& work) = 0;

  /// Called at the end, before the runner is destroyed.
  virtual void finish(Triangulation& t, const PhaseRunner& runner, const Threads& threads) = 0;
};

}  // namespace pardel::engine
