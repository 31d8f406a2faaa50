// A task: refines the part of the mesh in one box, until it cannot split any further triangle there.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "../decomposition/tiles.hpp"
#include "assessor.hpp"
#include "bucket_queue.hpp"
#include "deferral.hpp"
#include "insertion.hpp"

namespace pardel::engine {

/// A triangle that a task hands on: the task of another cell, or a later task of its own cell, has to process it.
struct HandedOn {
  QueuedTriangle triangle;
  Index cell;
};

/// The counts of a task, and the triangles that it leaves to other tasks. The order of each list is deterministic.
struct TaskResult {
  std::vector<HandedOn> handed_on;               ///< to other cells, or to its own if its indices were used up
  std::vector<QueuedTriangle> needs_larger_box;  ///< the point lies in the cell, but the cavity leaves the cell's box
  std::vector<QueuedTriangle> blocked;           ///< their points encroach on an edge that cannot be split
  std::vector<Deferred> deferred;                ///< for a later pass
  std::vector<TriangleId> changed;               ///< if asked for: the triangles that it made, and that still exist
  std::uint64_t inserted = 0, segment_splits = 0, refused = 0;
  std::uint64_t out_of_numbers = 0;   ///< how many of handed_on went to its own cell
  std::uint64_t against_promise = 0;  ///< how many of needs_larger_box should fit the box by T1
  bool left_alone = false;            ///< a triangle that breaks the goal was not split; it may not exist any more
  /// In a submesh: vertices around which the task needed triangles that the submesh does not have. It left alone what
  /// it wanted to split there. Then its result does not count.
  std::vector<VertexId> needs_more_at;
};

/// Works on one cell at a time. Each thread has a Task of its own. A run keeps only allocated memory for the next run,
/// no data.
class Task {
 public:
  /// own_cell_only: a triangle whose point lies in another cell is handed on even if the cavity fits the box.
  Task(Triangulation& t, const Assessor& assessor, const Criteria& criteria, double min_edge, bool own_cell_only)
      : t_(t), assessor_(assessor), insertion_(t, criteria, min_edge), own_cell_only_(own_cell_only) {}

  /// Called with the number of vertices inserted since the last call. May throw; the exception ends the run, and the
  /// triangulation stays consistent.
  using Report = std::function<void(std::uint64_t)>;
  /// The largest number of insertions, and of seeds examined, between two calls of a Report: about 0.1 ms.
  static constexpr std::uint64_t steps_between_reports = 64;

  /// The triangulation is a submesh: a task goes on if triangles are missing (TaskResult::needs_more_at). Otherwise it
  /// throws NotHeld.
  void begin_submesh() { is_in_submesh_ = true; }

  /// Refines in the box of `cell`. Starts with `seeds`, triangles whose corners lie in the box. list_changes: the
  /// result contains the list of changed triangles.
  TaskResult run(const Tiles& tiles, Index cell, std::span<const QueuedTriangle> seeds, const Deferral& later,
                 FreeIndices& free, const Report& report, bool list_changes = false);

  /// run() in single steps: call start(), then step() until it returns false, then finish().
  void start(const Tiles& tiles, Index cell, std::span<const QueuedTriangle> seeds, const Deferral& later,
             FreeIndices& free, const Report& report = {}, bool list_changes = false);
  [[nodiscard]] bool step();
  [[nodiscard]] TaskResult finish();

 private:
  void consider(TriangleId id) {
    const Shape shape(t_, t_.slots[id]);
    queue_if_bad(id, assessor_.assess(id, shape, hints_), shape);
  }
  void consider_changed();
  // Always inlined: otherwise the Assessment is passed through memory.
  [[gnu::always_inline]] void queue_if_bad(TriangleId id, const Assessment& a, const Measure& m) {
    if (a.need == Assessment::Need::nothing)
      result_.left_alone = result_.left_alone || a.left_alone;
    else if (later_.defers(a, m))
      result_.deferred.push_back({assessor_.entry(id, a), a});
    else
      queue_.push(assessor_.entry(id, a), a.key);
  }
  void process(QueuedTriangle triangle);
  /// Splits the triangle by Placement::search: of `first` and the candidates around the circumcentre, inserts one after
  /// which the fewest new triangles break the bounds of Insertion::breaking(); of these, the farthest from all
  /// vertices. If `first` cannot be inserted, tries nothing else, and returns the outcome for it.
  [[nodiscard]] Outcome insert_best(Point first, TriangleId id);
  /// Splits an encroached side of the triangle. If no such side can be split, and the triangle itself has to be split,
  /// returns the triangle's shortest side. Otherwise returns none().
  [[nodiscard]] EdgeRef split_encroached_side(QueuedTriangle triangle);
  /// Splits the edge on which the triangle's split point encroaches. If it cannot be split, the triangle is blocked.
  void split_blocker(QueuedTriangle triangle);
  [[nodiscard]] bool is_foreign(Point p) const { return own_cell_only_ && tiles_->cell_of(p) != cell_; }
  void hand_on_to_own_cell(QueuedTriangle triangle);
  /// Calls work(), which is about a triangle. In a submesh, notes the place if triangles are missing there.
  template <class Work>
  void with_triangles_around(TriangleId id, const Work& work);
  void note_missing_triangles(TriangleId around);
  void count_refused();
  /// Splits the edge, which the triangle or its split point encroaches.
  [[nodiscard]] Outcome split_edge(EdgeRef e, TriangleId on_behalf_of);
  [[nodiscard]] Outcome split_edge_at(Point p, EdgeRef e, Index segment);
  /// Hands the triangle on to the cell of p, the point that this task could not insert. If p lies in the task's own
  /// cell, the triangle needs a larger box.
  void hand_on(QueuedTriangle triangle, Point p);
  /// True if p, inserted in a face, left the box although its cavity fits by T1 (Lattice::radius_that_fits).
  /// Precondition: the tiles are the cells of a lattice.
  [[nodiscard]] bool violates_t1(Point p) const;

  Triangulation& t_;
  const Assessor& assessor_;
  Insertion insertion_;
  bool own_cell_only_, is_in_submesh_ = false;
  FreeIndices* free_ = nullptr;
  BucketQueue queue_;
  LocalHints hints_;
  TaskResult result_;
  const Tiles* tiles_ = nullptr;
  Index cell_ = 0;
  Box box_;
  Deferral later_;
  bool lists_changes_ = false;
  std::vector<QueuedTriangle> changed_;  ///< all triangles made; most do not exist any more
};

}  // namespace pardel::engine
