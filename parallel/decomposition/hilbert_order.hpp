// The order of points along a Hilbert curve: neighbours in the order are close in the plane.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "../../core/array.hpp"
#include "../../core/pslg.hpp"
#include "../arithmetic/box.hpp"
#include "../threads/threads.hpp"

namespace pardel::engine {

/// A grid of 2^16 by 2^16 cells over a square, and a Hilbert curve through its cells. A key is the place of a cell on
/// the curve. The curve passes through all cells of a quadrant of the square, or of a quadrant of a quadrant, and so
/// on, one after the other. So these cells have the keys of one range.
class CurveGrid {
 public:
  static constexpr unsigned levels = 16;                   ///< a key has two bits for each
  static constexpr double last_cell = (1U << levels) - 1;  ///< the last column and row

  /// The square: with the lower left corner and the longer side of `bounds`. It has one cell if that side is 0.
  explicit CurveGrid(const Box& bounds);

  /// Precondition of these: the point lies in the bounds.
  [[nodiscard]] std::uint32_t key(Point p) const;
  [[nodiscard]] std::uint32_t column(Point p) const { return cell(p.x - min_x_); }
  [[nodiscard]] std::uint32_t row(Point p) const { return cell(p.y - min_y_); }
  /// A square that divisions into four equal ones lead to: its column and row after `level` divisions, 0 to `levels`.
  struct Quadrant {
    std::uint32_t x = 0, y = 0;
    unsigned level = 0;

    [[nodiscard]] Quadrant part(unsigned i) const { return {2 * x + i / 2, 2 * y + i % 2, level + 1}; }
  };
  /// The first and the last key of a quadrant.
  [[nodiscard]] static std::uint32_t first_key(const Quadrant& quadrant);
  [[nodiscard]] static std::uint32_t last_key(const Quadrant& quadrant) {
    return static_cast<std::uint32_t>(first_key(quadrant) + ((std::uint64_t{1} << 2 * (levels - quadrant.level)) - 1));
  }
  /// A box that contains all points with these keys: the square of the quadrant, and a margin for rounding.
  [[nodiscard]] Box square(const Quadrant& quadrant) const;
  /// A small quadrant with the keys of all points in the box. Precondition: the box is finite.
  [[nodiscard]] Quadrant around(const Box& box) const;

 private:
  /// The column or row of a place, which may be outside. The argument is the distance from the first one.
  [[nodiscard]] std::uint32_t cell(double distance) const {
    return static_cast<std::uint32_t>(std::clamp(distance * scale_, 0.0, last_cell));
  }

  double min_x_, min_y_;
  double scale_;   ///< cells per unit of length; 0 if there is one cell
  double margin_;  ///< of square()
};

/// So few points are ordered by their coordinates, not along a curve.
inline constexpr std::size_t few_points = 16;

/// The indices of the points, ordered along a Hilbert curve through a grid of 2^16 by 2^16 cells over their bounding
/// square. Points in one cell are ordered recursively, along a curve through that cell. The order depends on
/// coordinates only, not on the order of the input, except among equal points. The number of threads does not change
/// the order. O(n) on typical input.
[[nodiscard]] Array<Index> hilbert_order(std::span<const Point> points, const Threads& threads = {});

/// The same for some of the points of a larger set: the order in which hilbert_order() has them among all points.
/// `grid`: over the bounding box of all points. Precondition: if a cell of the grid contains one of these points, all
/// points in it are among these. All points are more than few_points, or the grid has one cell.
[[nodiscard]] Array<Index> hilbert_order(std::span<const Point> points, const CurveGrid& grid,
                                         const Threads& threads = {});

}  // namespace pardel::engine
