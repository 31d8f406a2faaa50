// The other ranks of a run, as the refinement sees them.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "phase.hpp"

namespace pardel::engine {

/// Connects the refinement of this rank with that of the other ranks (ranks.hpp). The coarse levels are refined by
/// every rank alike. Then the mesh is divided. From then on, every rank runs the tasks of the cells that it owns, on
/// the part of the mesh around them, and the ranks exchange what they changed after every phase. All functions but
/// is_at_home(), is_first() and ranks() are collective. They throw Stopped if the run has to end.
class Partners {
 public:
  Partners() = default;
  Partners(const Partners&) = delete;
  Partners& operator=(const Partners&) = delete;
  virtual ~Partners() = default;

  /// Divides the finest tiles among the ranks, by `work` per cell, and removes from the mesh what this rank need not
  /// hold. Precondition: all ranks have the same mesh.
  virtual void divide(const Tiles& tiles, std::span<const double> work, PhaseRunner& runner) = 0;
  /// After divide(): true if this rank has to process the triangle. For each triangle, true on one rank.
  [[nodiscard]] virtual bool is_at_home(TriangleId id) const = 0;

  /// True on one rank.
  [[nodiscard]] virtual bool is_first() const = 0;
  /// The number of ranks.
  [[nodiscard]] virtual int ranks() const = 0;

  virtual void add_up(std::span<std::uint64_t> values) = 0;
  /// Sends the seeds of tasks whose cells belong to other ranks to these ranks, and marks the tasks as `elsewhere`.
  /// Adds the seeds that arrive to the tasks of this rank, in the order of cells. Decides which tasks list changes.
  virtual void deliver(std::vector<PlannedTask>& tasks) = 0;
  /// Tells the ranks that hold them about the triangles that the tasks have changed. Uses up the lists of changes.
  virtual void exchange_changes(std::vector<PlannedTask>& tasks) = 0;

  /// An excerpt of the mesh, and the triangles with which its refinement starts.
  struct Excerpt {
    /// Puts the triangles of the excerpt into `t`. Returns those that need a larger box. To be called once, after the
    /// runner was made for `t`.
    std::function<std::vector<QueuedTriangle>(PhaseRunner& runner)> fill;
    Triangulation& t;
  };
  /// Refines an excerpt. Returns the changed triangles.
  using RefineExcerpt = std::function<std::vector<TriangleId>(const Excerpt& excerpt)>;
  /// Splits the triangles whose cavities fit no box of the finest tiles. They are few. One rank gets the triangles near
  /// them, and calls `refine`; if this throws NotHeld, it gets more and starts again. All ranks then take over the
  /// changes. `rest`: the triangles of this rank.
  virtual void refine_rest(std::span<const QueuedTriangle> rest, const RefineExcerpt& refine) = 0;

  /// Called at the end, before the runner is destroyed.
  virtual void finish() = 0;
};

}  // namespace pardel::engine
