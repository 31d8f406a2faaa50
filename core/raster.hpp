// Raster: values on a regular grid of points, for example edge lengths made by a program for geographic data.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "pslg.hpp"
#include "result.hpp"
#include "size_source.hpp"

namespace pardel {

/// Values at the points of a grid. Point (i, j) of column i and row j lies at (first.x + i step_x, first.y + j step_y).
/// Preconditions of all functions: columns and rows are > 0, steps are finite and > 0, values.size() == columns * rows.
struct Raster {
  Index columns = 0, rows = 0;
  Point first;                    ///< the grid point in the south-west corner
  double step_x = 1, step_y = 1;  ///< the distances between grid points
  std::vector<double> values;     ///< row by row from south to north, each from west to east; NaN: no value

  /// The corners of the rectangle in which the raster has values. It extends half a step beyond the outer grid points.
  [[nodiscard]] Point low() const { return {first.x - 0.5 * step_x, first.y - 0.5 * step_y}; }
  [[nodiscard]] Point high() const { return {low().x + columns * step_x, low().y + rows * step_y}; }
  [[nodiscard]] bool covers(Point p) const {
    return p.x >= low().x && p.y >= low().y && p.x <= high().x && p.y <= high().y;
  }
};

/// The bilinear interpolation of the values at the four grid points around p. Beyond the outer grid points, the value
/// at the nearest point of their rectangle. Infinity if one of the values that have a weight is infinite, NaN if one is
/// NaN. O(1).
[[nodiscard]] double interpolate(const Raster& raster, Point p);

/// An upper bound on the squared slope of the interpolation in the cell between the grid points (i, j) and (i + 1, j +
/// 1), up to rounding; a column or row that does not exist counts as its neighbour. Infinity if a value is not finite.
[[nodiscard]] double squared_slope(const Raster& raster, Index i, Index j);

/// A function for Goal::size that interpolates. It shares one copy of the raster with its own copies, and several
/// threads may call it. `name` names the raster in messages.
class RasterSize {
 public:
  RasterSize(Raster raster, std::string name);
  /// Throws an Error (`invalid_input`), which the mesher returns, at a point without a value.
  [[nodiscard]] double operator()(Point p) const;
  [[nodiscard]] const Raster& raster() const { return field_->raster; }

 private:
  struct Field {
    Raster raster;
    std::string name;
  };
  std::shared_ptr<const Field> field_;
};

/// Makes a RasterSize.
///
/// Errors: `invalid_input` if a value is not greater than 0. NaN (no value) and infinity (no bound) are allowed.
[[nodiscard]] Result<std::function<double(Point)>> interpolated_size(Raster raster, std::string name = "the raster");

/// The Goal::sources of a raster of lengths, for a limit on gradation: the lines between neighbouring grid points where
/// the lengths in a cell change by more than `grading` per unit of distance, without most of those where the limit from
/// another grid point is stricter anyway. With these sources, the limit holds from all grid points and all lines
/// between them. Inside a cell the interpolation itself may be steeper. O(n).
///
/// Errors: `usage` if the limit is not a finite number greater than 0. Values that are not finite are no sources.
[[nodiscard]] Result<std::vector<SizeSource>> size_sources(const Raster& raster, double grading);

}  // namespace pardel
