// Edge lengths known at places of a subdomain, and between them.
#pragma once

#include <vector>

#include "../../parallel/sizing/background.hpp"
#include "../subdomain_mesher.hpp"

namespace pardel::engine {

/// subdomain.goal.size at the points of the subdomain and then at the centroids of its triangles. A number that bounds
/// no edge of the subdomain becomes the diagonal of the box around it, so that all numbers are finite.
[[nodiscard]] std::vector<double> sample_sizes(const Subdomain& subdomain);

/// A continuous function with given values at the corners and centroids of triangles, linear between them.
class SampledSizes {
 public:
  /// `values`: as from sample_sizes(). Preconditions: one value per point and triangle, and each triangle is
  /// counter-clockwise. O(n log n) for n triangles.
  SampledSizes(const std::vector<Point>& points, std::vector<std::array<Index, 3>> triangles,
               std::vector<double> values)
      : background_(points, std::move(triangles)), points_(points.size()), values_(std::move(values)) {}

  /// Beside the triangles, the value at the nearest place of them; infinity far away. O(log n) on typical input.
  [[nodiscard]] double at(Point p) const;

 private:
  Background background_;
  std::size_t points_;
  std::vector<double> values_;
};

}  // namespace pardel::engine
