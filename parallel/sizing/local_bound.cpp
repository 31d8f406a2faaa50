#include "local_bound.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "../../core/raster.hpp"
#include "../../core/result.hpp"
#include "../../core/support/shortest.hpp"

namespace pardel::engine {
namespace {

template <class Values>
LocalBound with_hint(const std::function<double(Point)>& function) {
  const auto* known = function.target<OnBackground<Values>>();
  if (known == nullptr) return {};
  return LocalBound([field = known->field](Point p, LocationHint& hint) { return field->at(p, hint); },
                    known->field->steepness());
}

/// A raster without gaps is a continuous field on a rectangle.
Steepness steepness(const Raster& raster) {
  constexpr double to_spare = 1.001, roundings = 64 * 0x1p-53;
  double steepest = 0;
  for (Index j = 0; j < raster.rows; ++j)
    for (Index i = 0; i < raster.columns; ++i) steepest = std::max(steepest, squared_slope(raster, i, j));
  if (steepest == INFINITY) return {};
  const double largest = *std::ranges::max_element(raster.values);
  return {to_spare * std::sqrt(steepest), roundings * largest * (double(raster.columns) + raster.rows)};
}

}  // namespace

double PointValues::at(Point p, LocationHint& hint) const {
  const Located found = background->locate(p, hint);
  if (limited && !background->is_near(found, p))
    throw Error{ErrorKind::invalid_input, name + " does not cover " + shortest(p)};
  return background->value_at(found, values);
}

double GradedValues::at(Point p, LocationHint& hint) const {
  const double length = grown.at(p, hint.source);
  return size ? std::min(length, size(p, hint)) : length;
}

Steepness GradedValues::steepness() const {
  const Steepness both = grown.steepness();
  if (!size) return both;
  return {std::max(both.slope, size.steepness().slope), std::max(both.blur, size.steepness().blur)};
}

LocalBound local_bound(std::function<double(Point)> function, double promised_slope) {
  if (!function) return {};
  if (LocalBound found = with_hint<PointValues>(function)) return found;
  if (LocalBound found = with_hint<TriangleValues>(function)) return found;
  if (LocalBound found = with_hint<GradedValues>(function)) return found;
  if (const auto* size = function.target<RasterSize>())
    return LocalBound([size = *size](Point p, LocationHint&) { return size(p); }, steepness(size->raster()));
  const Steepness steepness = promised_slope < INFINITY ? Steepness{promised_slope, 0} : Steepness{};
  return LocalBound([function = std::move(function)](Point p, LocationHint&) { return function(p); }, steepness);
}

}  // namespace pardel::engine
