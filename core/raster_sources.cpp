// The places of a raster from which a limit on gradation has to start.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "raster.hpp"
#include "support/shortest.hpp"

namespace pardel {
namespace {

/// Finds grid points whose length does not matter, because the limit from another grid point is below it. Then the
/// limit from the other point is below the limit from this one everywhere. In a raster with noise this holds for nearly
/// all points.
///
/// Each point learns from its eight neighbours whose limit is the lowest. Passes over the grid in four directions carry
/// this knowledge on. They can miss a point that does not matter, and never name one that does. Time: O(n).
class Overruled {
 public:
  Overruled(const Raster& raster, double grading) : raster_(raster), grading_(grading) {
    lowest_.reserve(raster.values.size());
    for (Index j = 0; j < raster.rows; ++j)
      for (Index i = 0; i < raster.columns; ++i) lowest_.push_back({i, j, raster.values[lowest_.size()]});
    for (int round = 0; round < 2; ++round) {
      for (Index j = 0; j < raster.rows; ++j) learn(j, j - 1);
      for (Index j = raster.rows; j-- > 0;) learn(j, j + 1);
    }
  }

  /// True if no limit has to start from the line between two neighbouring grid points. The limit from a point is a
  /// convex function. So it is below the whole line if it is below both ends.
  [[nodiscard]] bool contains(std::size_t a, std::size_t b) const {
    const auto both = [&](const Limit& from) { return is_below(from, a) && is_below(from, b); };
    return both(lowest_[a]) || both(lowest_[b]);
  }

 private:
  /// A length at a grid point: the limit from the grid point in this column and row.
  struct Limit {
    Index column, row;
    double length;
  };

  /// The points of row j learn from a row beside it, if that exists, and from each other in both directions.
  void learn(Index j, Index beside) {
    const Index columns = raster_.columns;
    if (beside < raster_.rows)
      for (Index i = 0; i < columns; ++i)
        for (Index k = i > 0 ? i - 1 : 0; k < columns && k <= i + 1; ++k) learn_from(i, j, k, beside);
    for (Index i = 1; i < columns; ++i) learn_from(i, j, i - 1, j);
    for (Index i = columns - 1; i-- > 0;) learn_from(i, j, i + 1, j);
  }

  void learn_from(Index column, Index row, Index of_column, Index of_row) {
    Limit& lowest = lowest_[index(column, row)];
    const Limit& from = lowest_[index(of_column, of_row)];
    if (from.column == lowest.column && from.row == lowest.row) return;
    const double length = limit(from, column, row);
    if (length < lowest.length) lowest = {from.column, from.row, length};
  }

  [[nodiscard]] std::size_t index(Index column, Index row) const { return std::size_t{row} * raster_.columns + column; }

  /// The length that the limit from one grid point allows at another one. It is NaN if there is no value, and no
  /// comparison with NaN holds. So points without a value neither learn nor teach.
  [[nodiscard]] double limit(const Limit& from, Index column, Index row) const {
    const double x = (static_cast<double>(from.column) - column) * raster_.step_x;
    const double y = (static_cast<double>(from.row) - row) * raster_.step_y;
    return raster_.values[index(from.column, from.row)] + grading_ * std::sqrt(x * x + y * y);
  }
  /// With a margin for rounding, so that two points cannot overrule each other.
  [[nodiscard]] bool is_below(const Limit& from, std::size_t at) const {
    const auto column = static_cast<Index>(at % raster_.columns), row = static_cast<Index>(at / raster_.columns);
    return limit(from, column, row) < (1 - 0x1p-30) * raster_.values[at];
  }

  const Raster& raster_;
  double grading_;
  std::vector<Limit> lowest_;  ///< at each grid point: the lowest limit that is known there
};

/// A line between two neighbouring grid points.
struct Line {
  std::size_t a, b;
};

/// The lines at cells in which the lengths change by more than `grading`, or nearly so.
std::vector<Line> steep_lines(const Raster& raster, double grading) {
  const auto at = [&](Index i, Index j) { return std::size_t{j} * raster.columns + i; };
  const auto change = [&](std::size_t a, std::size_t b) { return std::abs(raster.values[b] - raster.values[a]); };
  const auto is_steep = [&](Index i, Index j) {
    if (i >= raster.columns - 1 || j >= raster.rows - 1) return false;  // no cell; before the first one, i or j wraps
    return squared_slope(raster, i, j) >= 0.998 * grading * grading;
  };
  std::vector<Line> lines;
  for (Index j = 0; j < raster.rows; ++j)
    for (Index i = 0; i < raster.columns; ++i) {
      const bool here = is_steep(i, j);
      const std::size_t a = at(i, j), right = at(i + 1, j), up = at(i, j + 1);
      if (i + 1 < raster.columns &&
          (here || is_steep(i, j - 1) || !(change(a, right) < 0.999 * grading * raster.step_x)))
        lines.push_back({a, right});
      if (j + 1 < raster.rows && (here || is_steep(i - 1, j) || !(change(a, up) < 0.999 * grading * raster.step_y)))
        lines.push_back({a, up});
    }
  return lines;
}

}  // namespace

Result<std::vector<SizeSource>> size_sources(const Raster& raster, double grading) {
  if (!(grading > 0 && std::isfinite(grading)))
    return Error{ErrorKind::usage, "the limit on gradation must be finite and positive, not " + shortest(grading)};
  std::vector<SizeSource> sources;
  const std::vector<Line> lines = steep_lines(raster, grading);
  if (lines.empty()) return sources;
  const Overruled overruled(raster, grading);
  const auto place = [&](std::size_t k) {
    const std::size_t row = k / raster.columns, column = k % raster.columns;
    return Point{raster.first.x + static_cast<double>(column) * raster.step_x,
                 raster.first.y + static_cast<double>(row) * raster.step_y};
  };
  for (const auto& [a, b] : lines) {
    if (overruled.contains(a, b)) continue;
    const double from = raster.values[a], to = raster.values[b];
    if (std::isfinite(from) && std::isfinite(to))
      sources.push_back({place(a), place(b), from, to});
    else if (std::isfinite(from))
      sources.push_back({place(a), place(a), from, from});
    else if (std::isfinite(to))
      sources.push_back({place(b), place(b), to, to});
  }
  return sources;
}

}  // namespace pardel
