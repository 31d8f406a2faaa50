#include "raster.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "support/shortest.hpp"

namespace pardel {
namespace {

/// The position of a coordinate between two neighbouring columns or rows.
struct Between {
  std::size_t low, high;
  double share;  ///< of the higher one, from 0 to 1
};

Between position(double coordinate, double first, double step, Index count) {
  const double last = count - 1.0;
  const double index = std::clamp((coordinate - first) / step, 0.0, last);
  const double low = std::min(std::floor(index), std::max(0.0, last - 1));
  const auto at = static_cast<std::size_t>(low);
  return {at, std::min(at + 1, static_cast<std::size_t>(count - 1)), index - low};
}

/// a + share (b - a). A value without a weight does not count, not even NaN.
double mixed(double a, double b, double share) {
  if (share == 0) return a;
  if (share == 1) return b;
  if (std::isinf(a) || std::isinf(b)) return a + b;
  return a + share * (b - a);
}

}  // namespace

double interpolate(const Raster& raster, Point p) {
  const Between x = position(p.x, raster.first.x, raster.step_x, raster.columns);
  const Between y = position(p.y, raster.first.y, raster.step_y, raster.rows);
  const auto in_row = [&](std::size_t row) {
    const double* values = raster.values.data() + row * raster.columns;
    return mixed(values[x.low], values[x.high], x.share);
  };
  return mixed(in_row(y.low), in_row(y.high), y.share);
}

double squared_slope(const Raster& raster, Index i, Index j) {
  const Index right = std::min(i + 1, raster.columns - 1), up = std::min(j + 1, raster.rows - 1);
  const auto value = [&](Index k, Index l) { return raster.values[std::size_t{l} * raster.columns + k]; };
  const double a = value(i, j), b = value(right, j), c = value(i, up), d = value(right, up);
  for (const double v : {a, b, c, d})
    if (!std::isfinite(v)) return INFINITY;
  const double x = std::max(std::abs(b - a), std::abs(d - c)) / raster.step_x;
  const double y = std::max(std::abs(c - a), std::abs(d - b)) / raster.step_y;
  return x * x + y * y;
}

Result<std::function<double(Point)>> interpolated_size(Raster raster, std::string name) {
  for (std::size_t k = 0; k < raster.values.size(); ++k) {
    if (!(raster.values[k] <= 0)) continue;
    const std::size_t column = k % raster.columns, row = k / raster.columns;
    const Point at{raster.first.x + static_cast<double>(column) * raster.step_x,
                   raster.first.y + static_cast<double>(row) * raster.step_y};
    return Error{ErrorKind::invalid_input, name + ": the size in row " + std::to_string(raster.rows - row) +
                                               ", column " + std::to_string(column + 1) +
                                               " (counted from the north-west corner), at " + shortest(at) + ", is " +
                                               shortest(raster.values[k]) + "; sizes must be greater than 0"};
  }
  return std::function<double(Point)>(RasterSize(std::move(raster), std::move(name)));
}

RasterSize::RasterSize(Raster raster, std::string name)
    : field_(std::make_shared<const Field>(Field{std::move(raster), std::move(name)})) {}

double RasterSize::operator()(Point p) const {
  const double size = field_->raster.covers(p) ? interpolate(field_->raster, p) : NAN;
  if (std::isnan(size)) throw Error{ErrorKind::invalid_input, field_->name + " has no size at " + shortest(p)};
  return size;
}

}  // namespace pardel
