// A lattice that divides the plane into cells, and the box in which the task of a cell works.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "../../core/pslg.hpp"
#include "../arithmetic/box.hpp"

namespace pardel::engine {

/// A uniform lattice over a rectangle. Cell (i, j) has colour (i mod 2, j mod 2). The box of a cell is the cell with a
/// margin of half a cell on each side, so the boxes of cells of one colour are disjoint. Each task works in the box of
/// one cell.
class Lattice {
 public:
  [[nodiscard]] static constexpr unsigned colours() { return 4; }
  /// In the paper's lattice the side of a cell is at least this number of circumradii (THEORY.md, T1 and Lattice).
  static constexpr double radii_per_side = 4;

  Lattice(Box bounds, Index columns, Index rows)
      : bounds_(bounds),
        columns_(columns),
        rows_(rows),
        width_((bounds.max_x - bounds.min_x) / columns),
        height_((bounds.max_y - bounds.min_y) / rows) {}
  /// A lattice of nearly square cells. `along`: the number of cells in the direction in which the bounds are longer.
  static Lattice over(Box bounds, Index along) {
    const double width = bounds.max_x - bounds.min_x, height = bounds.max_y - bounds.min_y;
    const double side = std::max(width, height) / along;
    const auto count = [&](double extent) { return std::max(Index{1}, static_cast<Index>(std::round(extent / side))); };
    return {bounds, std::min(along, count(width)), std::min(along, count(height))};
  }

  [[nodiscard]] Index cells() const { return columns_ * rows_; }
  [[nodiscard]] Index columns() const { return columns_; }
  [[nodiscard]] Index rows() const { return rows_; }
  [[nodiscard]] double width() const { return width_; }    ///< of one cell
  [[nodiscard]] double height() const { return height_; }  ///< of one cell
  /// The shorter side of a cell. If there is only one column, its width is ignored; if there is only one row, its
  /// height is ignored, because there is no neighbour in this direction. INFINITY for a lattice of one cell.
  [[nodiscard]] double side() const {
    return std::min(columns_ > 1 ? width_ : INFINITY, rows_ > 1 ? height_ : INFINITY);
  }
  /// The cavity of a point in a cell lies in the box of the cell if no circumradius exceeds this value (T1; THEORY.md,
  /// Lattice). This holds for each triangle separately: a point in its circumdisk is at most two radii, that is half a
  /// side, away from its corners. The value is 1 % smaller than in the theorem, so rounding cannot cause a false error,
  /// even far from the origin.
  [[nodiscard]] double radius_that_fits() const { return 0.99 * side() / radii_per_side; }
  /// The cell of a point. A point beyond the bounds belongs to the nearest cell. A NaN coordinate is treated as the
  /// lowest value; the circumcentre of a very thin triangle can have such coordinates.
  [[nodiscard]] Index cell_of(Point p) const {
    return clamped((p.y - bounds_.min_y) / height_, rows_) * columns_ +
           clamped((p.x - bounds_.min_x) / width_, columns_);
  }
  [[nodiscard]] Point centre_of(Index cell) const {
    const Index column = cell % columns_, row = cell / columns_;
    return {bounds_.min_x + (column + 0.5) * width_, bounds_.min_y + (row + 0.5) * height_};
  }
  /// Two cells of one colour share neither a side nor a corner, so their points are more than one side apart
  /// (THEORY.md, Lattice (a)).
  [[nodiscard]] unsigned colour_of(Index cell) const { return (cell / columns_ % 2) * 2 + cell % columns_ % 2; }
  /// The box in which the task of a cell works. Boxes at the border of the lattice extend to infinity. The boxes of one
  /// colour are disjoint, so their tasks do not depend on each other (THEORY.md, Lattice (c) and T-region).
  [[nodiscard]] Box box_of(Index cell) const {
    const Index i = cell % columns_, j = cell / columns_;
    Box box;
    if (i > 0) box.min_x = bounds_.min_x + (i - 0.5) * width_;
    if (j > 0) box.min_y = bounds_.min_y + (j - 0.5) * height_;
    if (i + 1 < columns_) box.max_x = bounds_.min_x + (i + 1.5) * width_;
    if (j + 1 < rows_) box.max_y = bounds_.min_y + (j + 1.5) * height_;
    return box;
  }

  /// The cells around a cell, at most eight, in ascending order.
  [[nodiscard]] std::vector<Index> touching(Index cell) const {
    std::vector<Index> found;
    const Index i = cell % columns_, j = cell / columns_;
    const Index last_column = std::min(i + 1, columns_ - 1), last_row = std::min(j + 1, rows_ - 1);
    for (Index y = j - std::min(j, Index{1}); y <= last_row; ++y)
      for (Index x = i - std::min(i, Index{1}); x <= last_column; ++x)
        if (x != i || y != j) found.push_back(y * columns_ + x);
    return found;
  }
  /// The area of the box, without its parts beyond the border.
  [[nodiscard]] double box_area(Index) const { return 4 * width_ * height_; }

  /// The sum of a quantity over the box of a cell, given its values per cell. The value of the cell counts fully, the
  /// values of the four edge neighbours by one half, and the values of the four corner neighbours by one quarter.
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
    return !(offset > 0) ? 0 : std::min(count - 1, static_cast<Index>(std::min(offset, 4e9)));
  }

  Box bounds_;
  Index columns_, rows_;
  double width_, height_;
};

}  // namespace pardel::engine
