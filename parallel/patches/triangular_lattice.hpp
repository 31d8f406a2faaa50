// The points of a lattice of equilateral triangles, and which of them lie inside a boundary or near a segment.
#pragma once

#include <vector>

#include "../../core/pslg.hpp"
#include "../arithmetic/box.hpp"

namespace pardel::engine {

/// Places of a row: low, low + 2, ..., high.
struct Span {
  int row = 0, low = 0, high = 0;
  friend bool operator==(const Span&, const Span&) = default;
};

/// Where a segment crosses a row.
struct Crossing {
  int row = 0;
  double x = 0;  ///< a coordinate, not a place
};

/// The places of the lattice are pairs (x, row), in which x counts half edges, so x and row are both even or both odd.
/// Neighbours of (x, row) are (x - 2, row), (x + 2, row), and (x - 1, r) and (x + 1, r) for r = row - 1 and row + 1.
class TriangularLattice {
 public:
  /// `origin`: the point at (0, 0). `edge`: the length of an edge. `bounds`: no places outside are listed; what
  /// is asked for may be anywhere, but in the bounds the numbers of rows and columns have to fit into an `int`.
  TriangularLattice(Point origin, double edge, const Box& bounds = {});

  [[nodiscard]] Point at(int x, int row) const { return {origin_.x + x * half_edge_, origin_.y + row * height_}; }

  /// Appends where the segment ab crosses rows. A row crosses a closed chain of segments an even number of times, also
  /// if it passes through points of the chain: the lower end of a segment belongs to it, the upper end does not.
  void add_crossings(Point a, Point b, std::vector<Crossing>& crossings) const;
  /// The places inside a boundary, up to rounding, from the crossings of all its segments in any order. Merged.
  [[nodiscard]] std::vector<Span> inside(std::vector<Crossing> crossings) const;
  /// Appends the places that are nearer to the segment ab than the distance, up to rounding. a may be equal to b.
  void add_near(Point a, Point b, double distance, std::vector<Span>& spans) const;

 private:
  /// Appends the places of a row between two coordinates and in the bounds, if there are any.
  void add_between(int row, double from, double to, std::vector<Span>& spans) const;
  [[nodiscard]] int first_row(double y) const;
  [[nodiscard]] int last_row(double y) const;

  Point origin_;
  double half_edge_, height_;  ///< the distances of columns and of rows
  Box bounds_;
};

/// The union of the spans, in ascending order of row and low. There is a gap between any two spans of a row.
[[nodiscard]] std::vector<Span> merged(std::vector<Span> spans);
/// The places of the first list that are not in the second. Both are merged, and so is the result.
[[nodiscard]] std::vector<Span> without(const std::vector<Span>& spans, const std::vector<Span>& removed);

}  // namespace pardel::engine
