// The communicator: the other ranks of a run, as the refinement sees them.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "../criteria/estimates.hpp"
#include "phase.hpp"

namespace pardel::engine {

/// Triangles that wait on this rank: for the next pass, and for a larger box.
struct Waiting {
  std::vector<Deferred> deferred;
  std::vector<QueuedTriangle> needing_larger_box;
};

class CommunicatorInParts;

/// Connects the refinement of this rank with that of the other ranks (ranks.hpp). The coarse levels are refined by
/// every rank alike. Then the mesh is divided. From then on, every rank runs the tasks of the cells that it owns, on
/// the part of the mesh around them, and the ranks exchange what they changed after every phase. All functions but
/// is_at_home(), is_first(), ranks() and in_parts() are collective. They throw Stopped if the run has to end.
class Communicator {
 public:
  Communicator() = default;
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;
  virtual ~Communicator() = default;

  /// Divides the finest tiles among the ranks, by `work` per cell, and removes from the mesh what this rank need not
  /// hold. Precondition: all ranks have the same mesh.
  virtual void divide(const Tiles& tiles, std::span<const double> work, PhaseRunner& runner) = 0;
  /// After divide(), or from begin() on: true if this rank has to process the triangle. For each triangle, true on one
  /// rank.
  [[nodiscard]] virtual bool is_at_home(TriangleId id) const = 0;

  /// For a mesh that begins in parts: what else the communicator can do. Otherwise nullptr.
  [[nodiscard]] virtual CommunicatorInParts* in_parts() { return nullptr; }

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
  /// Splits the triangles whose cavities fit no box of the finest tiles, and tries those again that were blocked
  /// (TaskResult::blocked). They are few, unless many segments may not be split. One rank gets the triangles near them,
  /// and calls `refine`; if the submesh is too small, it gets more and starts again. All ranks then take over the
  /// changes. `rest`: the triangles of this rank.
  virtual void refine_rest(std::span<const QueuedTriangle> rest, const RefineSubmesh& refine) = 0;

  /// Called at the end, before the runner is destroyed.
  virtual void finish() = 0;
};

/// What the communicator of a mesh that begins in parts can do in addition. No rank ever has all of such a mesh. Each
/// rank assesses its part. One rank refines the coarse levels, in a gathered submesh. Then the mesh is divided anew,
/// with divide_anew() instead of divide(). All functions but holds() are collective.
class CommunicatorInParts {
 public:
  CommunicatorInParts() = default;
  CommunicatorInParts(const CommunicatorInParts&) = delete;
  CommunicatorInParts& operator=(const CommunicatorInParts&) = delete;
  virtual ~CommunicatorInParts() = default;

  /// To be called first. The indices of all vertices and triangles are in use.
  virtual void begin(PhaseRunner& runner) = 0;
  /// True if the slot contains a triangle.
  [[nodiscard]] virtual bool holds(TriangleId id) const = 0;
  [[nodiscard]] virtual Box bounds_of_all(const Box& here) = 0;
  /// Replaces each value by the largest one of all ranks.
  virtual void take_largest(std::span<double> values) = 0;
  /// Refines the coarse levels in a submesh. Returns what waits there for finer levels, or for a larger box.
  using RefineCoarse =
      std::function<Waiting(const Communicator::GatheredSubmesh& submesh, std::vector<TriangleId>& changed)>;
  /// Refines the coarse levels on one rank, which gets the due triangles and those around them; if the submesh is too
  /// small, it gets more and starts again. All ranks take over the changes. Returns what now waits on this rank in
  /// addition. `due`: the triangles of this rank that coarse levels have to split.
  [[nodiscard]] virtual Waiting refine_coarse(std::span<const Deferred> due, const RefineCoarse& refine) = 0;
  /// Divides the finest tiles among the ranks, by `work` per cell. Triangles move to the ranks that hold them from now
  /// on, and waiting ones to those where they are at home. Returns those that wait on this rank.
  [[nodiscard]] virtual Waiting divide_anew(const Tiles& tiles, std::span<const double> work, Waiting&& waiting) = 0;
};

/// Replaces the estimates by their sums over all ranks. Collective.
inline void add_up_estimates(std::span<double> estimates, Communicator& communicator) {
  std::vector<std::uint64_t> parts;
  for (const double each : estimates) parts.push_back(static_cast<std::uint64_t>(each * parts_of_estimate));
  communicator.add_up(parts);
  for (std::size_t i = 0; i < parts.size(); ++i) estimates[i] = static_cast<double>(parts[i]) / parts_of_estimate;
}

}  // namespace pardel::engine
