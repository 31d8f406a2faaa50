#include "weights.hpp"

#include <algorithm>
#include <cmath>

namespace pardel::engine {
namespace {

/// Twice the area of three corners, rounded. Where doubles cannot tell it from 0, or not to within `error`: exactly,
/// but for a few roundings.
double twice_area(Point a, Point b, Point c, double error) {
  const Orientation<double> turn(a.x - c.x, a.y - c.y, b.x - c.x, b.y - c.y);
  return std::abs(turn.determinant) >= turn.error && turn.error <= error ? turn.determinant
                                                                         : exact::twice_area(a, b, c);
}

}  // namespace

std::array<double, 3> weights_in(const std::array<Point, 3>& corners, Point p) {
  const auto& [a, b, c] = corners;
  const double determinant = Orientation<double>(a.x - c.x, a.y - c.y, b.x - c.x, b.y - c.y).determinant;
  const double error = 0x1p-48 * std::abs(determinant);
  const double area = twice_area(a, b, c, error);
  std::array<double, 3> weights{twice_area(b, c, p, error) / area, twice_area(c, a, p, error) / area,
                                twice_area(a, b, p, error) / area};
  for (double& weight : weights) weight = std::clamp(weight, 0.0, 1.0);
  return weights;
}

double blend(const std::array<double, 3>& weights, const std::array<double, 3>& values) {
  // From the nearest corner: so that rounding of the weights matters least, and nothing at a corner.
  const auto base = static_cast<unsigned>(std::ranges::max_element(weights) - weights.begin());
  const auto least = [&] {
    double extreme = values[base];
    for (unsigned i = 0; i < 3; ++i)
      if (weights[i] > 0) extreme = std::min(extreme, values[i]);
    return extreme;
  };
  const auto greatest = [&] {
    double extreme = values[base];
    for (unsigned i = 0; i < 3; ++i)
      if (weights[i] > 0) extreme = std::max(extreme, values[i]);
    return extreme;
  };
  double value = values[base], sum = 0;
  for (unsigned i = 0; i < 3; ++i) {
    if (!(weights[i] > 0)) continue;  // also if the value there is not finite
    if (i != base) value += weights[i] * (values[i] - values[base]);
    sum += weights[i] * values[i];
  }
  if (!std::isfinite(value)) value = sum;  // a difference was too large, or a value is not finite
  return std::isfinite(value) ? std::clamp(value, least(), greatest()) : value;
}

}  // namespace pardel::engine
