// The task of one cell in one phase: Ruppert's loop on the triangles whose split points the cell contains.
#pragma once

#include "../mesh/triangle.hpp"
#include "../rules/ruppert.hpp"
#include "division.hpp"

namespace pardel::schemes::cells {

/// A triangle that needs work or, if `side` is not negative, the side of a triangle that is to be split.
struct Waiting : KnownTriangle {
  int side = -1;  ///< a constrained side, upon which a circumcentre of another triangle encroaches
};

/// The point that Ruppert's rules first think of for t: the split point of an encroached side, or the circumcentre of a
/// bad triangle; nothing if t needs no work. It decides which cell is asked to work on t.
[[nodiscard]] std::optional<Point> first_point(const LinkedMesh& mesh, Index t, const Bounds& bounds);
/// The same for an entry. Precondition: it is not out of date.
[[nodiscard]] std::optional<Point> first_point(const LinkedMesh& mesh, const Waiting& w, const Bounds& bounds);

/// What a task used: the vertices of the closures of its cavities, and the triangles that it read or wrote.
struct Touched {
  std::vector<Index> vertices, triangles;
};

class Task {
 public:
  struct HandedOn {
    Waiting what;
    Index to;  ///< a cell
  };

  /// `list`: the entries of the cell. They are sorted by coordinates, because numbers depend on the order of tasks.
  Task(LinkedMesh& mesh, const Bounds& bounds, const Division& division, Index cell, std::vector<Waiting> list,
       bool records);

  /// Takes entries until it has inserted a point. False if there is no entry left.
  bool step();

  [[nodiscard]] Index cell() const { return cell_; }
  [[nodiscard]] std::uint64_t work() const { return work_; }
  /// For other cells of this division, from their next phase on.
  [[nodiscard]] const std::vector<HandedOn>& handed_on() const { return handed_on_; }
  /// For this cell's next phase: triangles that wait for another cell to split a side.
  [[nodiscard]] const std::vector<Waiting>& again() const { return again_; }
  /// For other divisions: triangles that are not due, and triangles whose insertions leave the box.
  [[nodiscard]] const std::vector<Waiting>& later() const { return later_; }
  [[nodiscard]] const std::vector<Waiting>& left_box() const { return left_box_; }
  /// Slots of new triangles. Some of them may have been replaced since.
  [[nodiscard]] const std::vector<Index>& made() const { return made_; }
  /// Empty unless the task records.
  [[nodiscard]] const Touched& touched() const { return touched_; }

 private:
  [[nodiscard]] std::optional<Insertion> insertion_of(const Waiting& w);
  [[nodiscard]] std::optional<Insertion> split(const Waiting& w, Side side);
  [[nodiscard]] bool owns(Point p) const;
  [[nodiscard]] bool stays_in_box(const Insertion& insertion) const;
  void record(const Cavity& cavity);
  void carry_out_for(const Waiting& w, const Insertion& insertion);
  /// Queues a new triangle, or hands it on, if it needs work.
  void consider(Index t);

  LinkedMesh& mesh_;
  const Bounds& bounds_;
  const Division& division_;
  Index cell_;
  bool records_;
  std::vector<Waiting> queue_;
  std::size_t next_ = 0;
  std::uint64_t work_ = 0;
  std::vector<HandedOn> handed_on_;
  std::vector<Waiting> again_, later_, left_box_;
  std::vector<Index> made_;
  Touched touched_;
};

}  // namespace pardel::schemes::cells
