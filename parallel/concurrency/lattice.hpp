// How the plane is cut into tiles, and what a task that works on a tile may touch.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "../../core/pslg.hpp"

namespace pardel::engine {

/// Half-open: [min_x, max_x) x [min_y, max_y).
struct Box {
  double min_x = -INFINITY, min_y = -INFINITY, max_x = INFINITY, max_y = INFINITY;
  [[nodiscard]] bool is_everything() const {
    return min_x == -INFINITY && min_y == -INFINITY && max_x == INFINITY && max_y == INFINITY;
  }
  [[nodiscard]] bool contains(Point p) const { return p.x >= min_x && p.x < max_x && p.y >= min_y && p.y < max_y; }
};

inline constexpr Box nowhere{INFINITY, INFINITY, -INFINITY, -INFINITY};

/// The least box around both.
[[nodiscard]] inline Box united(const Box& a, const Box& b) {
  return {std::min(a.min_x, b.min_x), std::min(a.min_y, b.min_y), std::max(a.max_x, b.max_x),
          std::max(a.max_y, b.max_y)};
}

/// A uniform lattice over a rectangle. Cell (i, j) has colour (i mod 2, j mod 2); the task of a cell owns its
/// cell and half a cell around it, so that the boxes of one colour are disjoint.
class Lattice {
 public:
  static constexpr unsigned colours = 4;
  /// The paper's lattice: a cell's side in circumradii, at least (THEORY, T1 and Lattice).
  static constexpr double radii_per_side = 4;

  Lattice(Box bounds, Index columns, Index rows)
      : bounds_(bounds),
        columns_(columns),
        rows_(rows),
        width_((bounds.max_x - bounds.min_x) / columns),
        height_((bounds.max_y - bounds.min_y) / rows) {}
  /// Nearly square cells, `along` of them in the direction in which the bounds are longer.
  static Lattice over(Box bounds, Index along) {
    const double width = bounds.max_x - bounds.min_x, height = bounds.max_y - bounds.min_y;
    const double side = std::max(width, height) / along;
    const auto count = [&](double extent) { return std::max(Index{1}, static_cast<Index>(std::round(extent / side))); };
    return {bounds, std::min(along, count(width)), std::min(along, count(height))};
  }

  [[nodiscard]] Index cells() const { return columns_ * rows_; }
  [[nodiscard]] Index columns() const { return columns_; }
  [[nodiscard]] Index rows() const { return rows_; }
  [[nodiscard]] double width() const { return width_; }    ///< of a cell
  [[nodiscard]] double height() const { return height_; }  ///< of a cell
  /// The shorter side of a cell. Where there is but one column or row, nothing lies beside it, and
  /// its width or height does not count; INFINITY for a single cell.
  [[nodiscard]] double side() const {
    return std::min(columns_ > 1 ? width_ : INFINITY, rows_ > 1 ? height_ : INFINITY);
  }
  /// T1: the cavity of a point in a cell lies in the cell's box where no circumradius exceeds this (THEORY, Lattice).
  /// It holds of each triangle by itself: p, in the circumdisk, lies within two radii, half a side, of its corners. One
  /// hundredth less than the theorem's keeps rounding from passing for a mistake, far from the origin too.
  [[nodiscard]] double radius_that_fits() const { return 0.99 * side() / radii_per_side; }
  /// The cell of a point; points beyond the bounds belong to the nearest cell
  /// (and those that are not a number, from needles, to the first).
  [[nodiscard]] Index cell_of(Point p) const {
    return clamped((p.y - bounds_.min_y) / height_, rows_) * columns_ +
           clamped((p.x - bounds_.min_x) / width_, columns_);
  }
  [[nodiscard]] Point centre_of(Index cell) const {
    return {bounds_.min_x + (cell % columns_ + 0.5) * width_, bounds_.min_y + (cell / columns_ + 0.5) * height_};
  }
  [[nodiscard]] unsigned colour_of(Index cell) const { return (cell / columns_ % 2) * 2 + cell % columns_ % 2; }
  /// What the task of a cell may touch. Boxes at the rim extend to infinity.
  [[nodiscard]] Box box_of(Index cell) const {
    const Index i = cell % columns_, j = cell / columns_;
    Box box;
    if (i > 0) box.min_x = bounds_.min_x + (i - 0.5) * width_;
    if (j > 0) box.min_y = bounds_.min_y + (j - 0.5) * height_;
    if (i + 1 < columns_) box.max_x = bounds_.min_x + (i + 1.5) * width_;
    if (j + 1 < rows_) box.max_y = bounds_.min_y + (j + 1.5) * height_;
    return box;
  }

  /// The part that the box of a cell has in a quantity given per cell: all of the cell, half of the cells beside
  /// it, a quarter of those at its corners.
  [[nodiscard]] double sum_over_box(Index cell, const std::vector<double>& per_cell) const {
    const Index i = cell % columns_, j = cell / columns_;
    double sum = 0;
    for (Index y = j > 0 ? j - 1 : 0; y <= std::min(j + 1, rows_ - 1); ++y)
      for (Index x = i > 0 ? i - 1 : 0; x <= std::min(i + 1, columns_ - 1); ++x)
        sum += per_cell[y * columns_ + x] * (x == i ? 1 : 0.5) * (y == j ? 1 : 0.5);
    return sum;
  }

 private:
  [[nodiscard]] static Index clamped(double offset, Index count) {
    const double index = std::floor(offset);
    return !(index > 0) ? 0 : std::min(count - 1, static_cast<Index>(std::min(index, 4e9)));
  }

  Box bounds_;
  Index columns_, rows_;
  double width_, height_;
};

}  // namespace pardel::engine
