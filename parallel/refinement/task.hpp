// A task: refines what lies in one box, by itself, until nothing in it can be done any more.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "../concurrency/lattice.hpp"
#include "assessor.hpp"
#include "bucket_queue.hpp"
#include "deferral.hpp"
#include "insertion.hpp"

namespace pardel::engine {

/// A triangle that a task could not finish, and the cell that has to.
struct HandedOn {
  Queued triangle;
  Index cell;
};

/// What a task did and what it leaves to others, each list in a fixed order.
struct TaskResult {
  std::vector<HandedOn> handed_on;  ///< to other cells, or to its own when its numbers were used up
  std::vector<Queued> stuck;        ///< the box of their own cell is too small
  std::vector<Deferred> deferred;   ///< for a finer lattice or the next round
  std::uint64_t inserted = 0, segment_splits = 0, refused = 0;
  std::uint64_t out_of_numbers = 0;   ///< how many of handed_on went to its own cell
  std::uint64_t against_promise = 0;  ///< how many of stuck should have fitted
  bool left_alone = false;            ///< some triangle that breaks the goal was not split; it may be gone by now
};

/// Works on one cell at a time; a thread has one of its own. Nothing of one run is left for the next but
/// allocated memory.
class Task {
 public:
  /// own_cell_only: a point in another cell is handed on even where the box has room for its cavity.
  Task(Triangulation& t, const Judge& judge, const Criteria& criteria, double min_edge, bool own_cell_only)
      : t_(t), judge_(judge), insertion_(t, criteria, min_edge), own_cell_only_(own_cell_only) {}

  /// Refines in the box of `cell`, starting with `seeds`, whose corners lie in the box. go_on(n) is asked now and
  /// then, n being the number of vertices inserted since it was asked last; when it says no, the run ends early.
  TaskResult run(const Lattice& lattice, Index cell, std::span<const Queued> seeds, const Deferral& later,
                 Supply& supply, const std::function<bool(std::uint64_t)>& go_on);

  /// The same, one insertion at a time: start, step while it says that there is more to do, finish.
  void start(const Lattice& lattice, Index cell, std::span<const Queued> seeds, const Deferral& later, Supply& supply);
  [[nodiscard]] bool step();
  [[nodiscard]] TaskResult finish() { return std::move(result_); }

 private:
  void consider(TriangleId id) {
    const Shape shape(t_, t_.slots[id]);
    queue_if_bad(id, judge_.assess(id, shape), shape);
  }
  void consider_changed();
  // Always inlined, for an Assessment handed over a call goes through memory.
  [[gnu::always_inline]] void queue_if_bad(TriangleId id, const Assessment& a, const Measure& m) {
    if (a.need == Assessment::Need::nothing)
      result_.left_alone = result_.left_alone || a.left_alone;
    else if (later_.applies_to(a, m))
      result_.deferred.push_back({judge_.queued(id, a), a});
    else
      queue_.push(judge_.queued(id, a), a.key);
  }
  void process(Queued triangle);
  [[nodiscard]] bool is_foreign(Point p) const { return own_cell_only_ && lattice_->cell_of(p) != cell_; }
  void give_up(Queued triangle);
  [[nodiscard]] Outcome split_edge(EdgeRef e);
  void hand_on(Queued triangle, Point p);
  /// A point p in a face of its own cell did not fit the box, though T1 says that it does.
  [[nodiscard]] bool breaks_promise(Point p) const;

  Triangulation& t_;
  const Judge& judge_;
  Insertion insertion_;
  bool own_cell_only_;
  Supply* supply_ = nullptr;
  BucketQueue queue_;
  TaskResult result_;
  const Lattice* lattice_ = nullptr;
  Index cell_ = 0;
  Box box_;
  Deferral later_;
};

}  // namespace pardel::engine
