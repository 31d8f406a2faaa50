#include "sampled_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../../parallel/triangulation/triangle_shape.hpp"
#include "../subdomains/box_of.hpp"

namespace pardel::engine {

std::vector<double> sample_sizes(const Subdomain& subdomain) {
  const Box box = box_of(subdomain);
  const double diagonal = std::hypot(box.max_x - box.min_x, box.max_y - box.min_y);
  const auto size_at = [&](Point p) { return std::min(subdomain.goal.size(p), diagonal); };
  std::vector<double> values;
  values.reserve(subdomain.points.size() + subdomain.triangles.size());
  for (const Point p : subdomain.points) values.push_back(size_at(p));
  for (const auto& [a, b, c] : subdomain.triangles)
    values.push_back(size_at(centroid_of(subdomain.points[a], subdomain.points[b], subdomain.points[c])));
  return values;
}

double SampledSizes::at(Point p) const {
  const Located place = background_.locate(p);
  if (place.triangle == no_index || !background_.is_near(place, p)) return std::numeric_limits<double>::infinity();
  double mean = 0;
  for (const Index v : place.v) mean += values_[v] / 3;
  const double linear = background_.value_at(place, std::span(values_).first(points_));
  return linear + 3 * std::ranges::min(place.weight) * (values_[points_ + place.triangle] - mean);
}

}  // namespace pardel::engine
