// A fixed triangulation for interpolation: point location and barycentric weights.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "../../core/array.hpp"
#include "../../core/mesh.hpp"
#include "../concurrency/lattice.hpp"
#include "../concurrency/threads.hpp"

namespace pardel::engine {

/// The position of a point in a Background.
struct Located {
  Index triangle = no_index;
  std::array<Index, 3> v{};
  std::array<double, 3> weight{};  ///< barycentric, >= 0, sum 1
};

/// Owns copies of the points and triangles, and a hierarchy of bounding boxes. It is immutable, so several threads may
/// use it at the same time.
class Background {
 public:
  /// O(n log n).
  Background(std::span<const Point> points, std::vector<std::array<Index, 3>> triangles, const Threads& threads = {});

  /// The triangle that contains p, and the weights of p in it. Close to a boundary, no triangle may contain p because
  /// of rounding: then a nearest triangle, and the weights of its point nearest to p. O(log n) on typical input.
  [[nodiscard]] Located locate(Point p) const;
  /// The linear interpolation of the values at the points. O(log n) on typical input.
  [[nodiscard]] double interpolate(Point p, std::span<const double> value_per_point) const;

 private:
  [[nodiscard]] Located weights_in(Index triangle, Point p) const;

  std::vector<Point> points_;
  std::vector<std::array<Index, 3>> triangles_;  ///< in the order of the leaves of the hierarchy
  Array<Index> number_;                          ///< the triangle of each leaf
  std::vector<Box> boxes_;                       ///< an implicit binary tree: root at 1, leaves from leaf_count_ on
  std::size_t leaf_count_ = 1;
};

}  // namespace pardel::engine
