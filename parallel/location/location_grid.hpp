// A grid over the plane, for point location. Its outermost cells are unbounded.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "../arithmetic/box.hpp"
#include "../arithmetic/predicates.hpp"

namespace pardel::engine {

/// The lines of a grid in one direction. A number belongs to one interval, which never decreases if the number grows:
/// so the numbers between two others belong to the intervals between theirs, however the arithmetic rounds.
class GridLines {
 public:
  GridLines() = default;
  /// `count` intervals over [from, to], count >= 1.
  GridLines(double from, double to, std::size_t count)
      : from_(from), per_unit_(static_cast<double>(count) / (to - from)), last_(static_cast<double>(count - 1)) {
    if (!std::isfinite(per_unit_)) per_unit_ = last_ = 0;
    if (per_unit_ > 0) {
      width_ = 1 / per_unit_;
      blur_ = 0x1p-20 * width_ + 0x1p-48 * std::max(std::abs(from), std::abs(to));
    }
  }
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(last_) + 1; }
  /// The interval of a finite number.
  [[nodiscard]] std::size_t at(double x) const {
    return static_cast<std::size_t>(std::clamp((x - from_) * per_unit_, 0.0, last_));
  }
  /// No number of this interval is less, or greater, among those in [least, greatest].
  [[nodiscard]] double begin(std::size_t i, double least) const {
    return i == 0 ? least : std::max(least, from_ + static_cast<double>(i) * width_ - blur_);
  }
  [[nodiscard]] double end(std::size_t i, double greatest) const {
    return i + 1 == count() ? greatest : std::min(greatest, from_ + static_cast<double>(i + 1) * width_ + blur_);
  }

 private:
  double from_ = 0, per_unit_ = 0, last_ = 0;
  double width_ = 0, blur_ = 0;  ///< of an interval; more than the rounding of its ends
};

struct LocationGrid {
  GridLines x, y;
  std::size_t first_cell = 0;  ///< the number that the owner of the grid gives to its first cell

  [[nodiscard]] std::size_t cells() const { return x.count() * y.count(); }
  /// From 0.
  [[nodiscard]] std::size_t cell_of(Point p) const { return y.at(p.y) * x.count() + x.at(p.x); }
  /// The number of cells that touch a box.
  [[nodiscard]] std::size_t cells_of(const Box& box) const {
    return (x.at(box.max_x) - x.at(box.min_x) + 1) * (y.at(box.max_y) - y.at(box.min_y) + 1);
  }
  /// Calls visit(cell) for all cells with points of a counter-clockwise triangle, and for few others. `box`: around
  /// the triangle.
  template <class Visit>
  void for_each_cell(const std::array<Point, 3>& corners, const Box& box, const Visit& visit) const {
    const std::size_t left = x.at(box.min_x), right = x.at(box.max_x);
    const std::size_t low = y.at(box.min_y), high = y.at(box.max_y);
    const bool are_few = left == right || low == high;
    for (std::size_t row = low; row <= high; ++row)
      for (std::size_t column = left; column <= right; ++column) {
        const Box cell{x.begin(column, box.min_x), y.begin(row, box.min_y), x.end(column, box.max_x),
                       y.end(row, box.max_y)};
        if (are_few || !lies_beside(cell, corners)) visit(row * x.count() + column);
      }
  }

 private:
  /// True if the box certainly lies to the right of an edge of the triangle.
  [[nodiscard]] static bool lies_beside(const Box& box, const std::array<Point, 3>& corners) {
    for (unsigned i = 0; i < 3; ++i) {
      const Point a = corners[i], b = corners[(i + 1) % 3];
      // The corner of the box that is farthest to the left.
      const Point q{b.y > a.y ? box.min_x : box.max_x, b.x > a.x ? box.max_y : box.min_y};
      const Orientation<double> turn(b.x - a.x, b.y - a.y, q.x - a.x, q.y - a.y);
      if (turn.determinant < -turn.error) return true;
    }
    return false;
  }
};

}  // namespace pardel::engine
