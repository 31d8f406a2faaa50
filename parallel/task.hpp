// A task: refines what lies in one box, by itself, until nothing in it can be done any more.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "../core/mutants.hpp"
#include "bucket_queue.hpp"
#include "constraints.hpp"
#include "criteria.hpp"
#include "insertion.hpp"
#include "mesher.hpp"
#include "small_angles.hpp"
#include "tiles.hpp"

namespace pardel {

/// What a triangle asks for.
struct Assessment {
  enum class Need : std::uint8_t { nothing, split_edge, split_triangle };
  Need need = Need::nothing;
  unsigned side = 0;  ///< the side to split
  unsigned key = 0;   ///< its place in the queue
  double longest_squared = 0;
  bool left_alone = false;  ///< breaks the goal, but nothing is to be done about it
};

/// The decisions of the refinement: pure functions of the triangulation.
class Judge {
 public:
  Judge(const Triangulation& t, const Lines& lines, const Criteria& criteria, const Options& options)
      : t_(t),
        lines_(lines),
        criteria_(criteria),
        options_(options),
        squared_floor_(options.min_edge * options.min_edge) {}

  /// Whether the slot still holds the triangle that was queued.
  [[nodiscard]] bool is_current(Queued q) const { return t_.slots[q.id].v[0] == q.first_corner; }
  [[nodiscard]] Assessment assess(TriangleId id) const { return assess(id, Shape(t_, t_.slots[id])); }
  [[nodiscard]] Assessment assess(TriangleId id, const Measure& m) const {
    return t_.slots[id].any_constrained() ? assess_beside_constraint(id, m) : assess_inside(id, m);
  }
  /// The same for a triangle whose sides cannot be split, encroached or not.
  [[nodiscard]] Assessment assess_inside(TriangleId id) const { return assess_inside(id, Shape(t_, t_.slots[id])); }
  [[nodiscard]] Assessment assess_inside(TriangleId id, const Measure& m) const {
    const bool large = too_large(id, m);
    if (!large && !criteria_.bad_shape(m)) return {};
    const double shortest = m.shortest_squared();
    const bool by_shape_alone = mutated("exemption_before_size") || !large;
    if (shortest < squared_floor_ || (by_shape_alone && small_angle(t_, lines_, t_.slots[id], m)))
      return {.left_alone = true};
    return {Assessment::Need::split_triangle, 0, BucketQueue::key(shortest), m.longest_squared(), false};
  }
  [[nodiscard]] bool has_local_size() const { return criteria_.has_local_size(); }
  /// Breaks the criteria, justified or not.
  [[nodiscard]] bool breaks_goal(TriangleId id) const;
  /// A constrained side that a conforming goal wants Delaunay and that is not, or 3.
  [[nodiscard]] unsigned non_delaunay_side(TriangleId id) const;
  [[nodiscard]] bool forbidden(EdgeRef e) const;  ///< may not be split by the caller's wish
  [[nodiscard]] bool below_floor(EdgeRef e) const;
  [[nodiscard]] bool too_large(TriangleId id) const { return too_large(id, Shape(t_, t_.slots[id])); }
  /// The point that the assessment's need puts in.
  [[nodiscard]] Point point_for(TriangleId id, const Assessment& a) const;
  [[nodiscard]] Point point_on(EdgeRef e) const;
  [[nodiscard]] Point point_in(TriangleId id) const { return criteria_.split_point(Shape(t_, t_.slots[id])); }
  [[nodiscard]] Index line_of(EdgeRef e) const;
  [[nodiscard]] Index region_of(TriangleId id) const { return t_.region.empty() ? no_index : t_.region[id]; }

 private:
  [[nodiscard]] Assessment assess_beside_constraint(TriangleId id, const Measure& m) const;
  [[nodiscard]] unsigned encroached_side(TriangleId id, const Slot& slot, const Measure& m) const;
  [[nodiscard]] bool too_large(TriangleId id, const Measure& m) const {
    return criteria_.too_large(m) ||
           (criteria_.has_local_size() && criteria_.too_large_locally(Shape(t_, t_.slots[id]), region_of(id)));
  }

  const Triangulation& t_;
  const Lines& lines_;
  const Criteria& criteria_;
  const Options& options_;
  double squared_floor_;
};

/// A triangle that a pass left for a later one, with its key in the queue and the key of the square of its longest
/// side, as they were then.
struct Deferred {
  Queued triangle;
  std::uint16_t key, longest;

  Deferred(Queued what, const Assessment& a)
      : triangle(what),
        key(static_cast<std::uint16_t>(a.key)),
        longest(static_cast<std::uint16_t>(BucketQueue::key(a.longest_squared))) {}
};

/// What a pass leaves for a later one: triangles no longer than `longest_squared`, or whose circumradius is at most
/// this, wait for a finer lattice, those whose key is above `last_key` for the next round.
struct Deferral {
  double longest_squared = 0;
  double squared_radius = 0;
  unsigned last_key = BucketQueue::last;
  [[nodiscard]] bool applies_to(const Assessment& a, const Measure& m) const {
    return a.longest_squared <= longest_squared || a.key > last_key ||
           (squared_radius > 0 && m.squared_circumradius() <= squared_radius);
  }
  /// By the keys alone. A neighbour across a segment may have changed since what the triangle asks for; whatever is
  /// passed over for that, the last pass looks at.
  [[nodiscard]] bool applied_to(const Deferred& d) const {
    const unsigned least = BucketQueue::key(longest_squared);
    return d.key > last_key || (mutated("deferral_by_rounded_lengths") ? d.longest <= least : d.longest < least);
  }
};

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
      result_.deferred.push_back({{id, t_.slots[id].v[0]}, a});
    else
      queue_.push({id, t_.slots[id].v[0]}, a.key);
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

}  // namespace pardel
