// Edge lengths known at places of a subdomain, and between them.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

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
  SampledSizes(std::vector<Point> points, std::vector<std::array<Index, 3>> triangles, std::vector<double> values);

  /// Infinity at places that are far from all triangles. O(log² n) if few triangles overlap in each place.
  [[nodiscard]] double at(Point p) const;

 private:
  /// A square of a grid. The grids of all levels begin at low_; the squares of a level have the side 2^level.
  struct Square {
    int level;
    std::int64_t column, row;
  };
  [[nodiscard]] static std::uint64_t key_of(const Square& square);
  [[nodiscard]] Square square_around(Point p, int level) const;
  /// The least of the three barycentric coordinates, negative outside the triangle, and the value.
  [[nodiscard]] std::pair<double, double> in_triangle(Index triangle, Point p) const;

  std::vector<Point> points_;
  std::vector<std::array<Index, 3>> triangles_;
  std::vector<double> values_;
  Point low_;
  std::vector<int> levels_;                             ///< those in use, ascending
  std::vector<std::pair<std::uint64_t, Index>> known_;  ///< squares and the triangles that meet them, ascending
};

}  // namespace pardel::engine
