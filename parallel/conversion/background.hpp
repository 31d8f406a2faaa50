// A fixed triangulation to interpolate on: what triangle a point lies in, and its weights there.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "../../core/array.hpp"
#include "../../core/mesh.hpp"
#include "../concurrency/lattice.hpp"

namespace pardel::engine {

/// Where a point lies in a Background.
struct Located {
  Index triangle = no_index;
  std::array<Index, 3> v{};
  std::array<double, 3> weight{};  ///< barycentric, >= 0, sum 1
};

/// Owns copies of points and triangles and a hierarchy of boxes over them. Immutable, so callable from
/// several threads.
class Background {
 public:
  /// O(n log n).
  Background(std::span<const Point> points, std::vector<std::array<Index, 3>> triangles);

  /// The triangle that contains p or, where none does (beyond a rounded boundary), one of those nearest to
  /// p, with the weights of the nearest point of it. O(log n) typical.
  [[nodiscard]] Located locate(Point p) const;
  [[nodiscard]] double interpolate(Point p, std::span<const double> value_per_point) const;

 private:
  [[nodiscard]] Located weights_in(Index triangle, Point p) const;

  std::vector<Point> points_;
  std::vector<std::array<Index, 3>> triangles_;  ///< in the order of the leaves
  Array<Index> number_;                          ///< leaf -> triangle
  std::vector<Box> boxes_;                       ///< an implicit binary tree, the root at 1, leaves at leaf_count_ + i
  std::size_t leaf_count_ = 1;
};

}  // namespace pardel::engine
