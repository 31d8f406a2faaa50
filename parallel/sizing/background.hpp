// A fixed triangulation for interpolation: point location and barycentric weights.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "../../core/array.hpp"
#include "../../core/mesh.hpp"
#include "../arithmetic/box.hpp"
#include "../threads/threads.hpp"

namespace pardel::engine {

/// The position of a point in a Background.
struct Located {
  Index triangle = no_index;
  std::array<Index, 3> v{};
  std::array<double, 3> weight{};  ///< barycentric, >= 0, sum 1
};

/// The place on the boundary of the same triangle whose least weight is zero.
[[nodiscard]] inline Located on_nearest_side(Located at) {
  auto& weight = at.weight;
  *std::ranges::min_element(weight) = 0;
  const double sum = weight[0] + weight[1] + weight[2];
  for (double& each : weight) each /= sum;
  return at;
}

/// The place where the last search ended, and where the next one starts: a leaf of a Background, a source of a
/// SizeEnvelope. It determines only the time that the search takes. Threads do not share a hint.
struct LocationHint {
  Index leaf = no_index;
  Index source = 0;
};

/// How fast a field changes: its values at two points differ by at most slope * distance + blur. The blur is the
/// rounding error of the values.
struct Steepness {
  double slope = INFINITY, blur = INFINITY;
};

/// Owns copies of the points and triangles, and a hierarchy of bounding boxes. It is immutable, so several threads may
/// use it at the same time.
class Background {
 public:
  /// O(n log n).
  Background(std::span<const Point> points, std::vector<std::array<Index, 3>> triangles, const Threads& threads = {});

  /// The triangle that contains p in its interior, and the weights of p in it. If p lies on an edge, or outside because
  /// of rounding: a nearest triangle, and the weights of its point nearest to p. The interiors are found by a walk from
  /// the hint, decided exactly, so the result depends neither on the hint nor on triangles that are farther away. O(1)
  /// if p is near the last point, O(log n) without a hint on typical input.
  [[nodiscard]] Located locate(Point p, LocationHint& hint) const;
  [[nodiscard]] Located locate(Point p) const {
    LocationHint none;
    return locate(p, none);
  }
  /// The linear interpolation of the values at the points.
  [[nodiscard]] double value_at(const Located& at, std::span<const double> value_per_point) const;
  [[nodiscard]] double interpolate(Point p, std::span<const double> value_per_point) const {
    return value_at(locate(p), value_per_point);
  }
  /// Of the interpolation of these values. Infinite if a triangle is so thin that rounding may hide its slope, and if
  /// the triangulation is not convex: beyond its border the value at the nearest point counts, which may jump there.
  /// O(n).
  [[nodiscard]] Steepness steepness(std::span<const double> value_per_point) const;
  /// True if p is in the triangle at which it was located, or not farther from it than the length of its longest side.
  [[nodiscard]] bool is_near(const Located& at, Point p) const;

 private:
  /// A leaf of the hierarchy: a triangle, with its neighbours as leaves.
  struct Leaf {
    std::array<Index, 3> v, n;
    double twice_area;
  };
  enum class Walk : std::uint8_t { inside, on_edge, lost };

  [[nodiscard]] std::array<Point, 3> corners(const Leaf& leaf) const {
    return {points_[leaf.v[0]], points_[leaf.v[1]], points_[leaf.v[2]]};
  }
  static constexpr unsigned no_side = 4, on_side = 5;
  [[nodiscard]] bool is_convex() const;
  [[nodiscard]] unsigned side_towards(Point p, const Leaf& leaf) const;
  [[nodiscard]] Walk walk(Point p, Index& leaf, int steps, Located& found) const;
  [[nodiscard]] Index leaf_near(Point p) const;
  [[nodiscard]] Located search(Point p) const;
  [[nodiscard]] Located weights_in(Index leaf, Point p) const;
  [[nodiscard]] Located nearest_in(Index leaf, Point p) const;
  [[nodiscard]] double squared_distance_to(const Located& at, Point p) const;
  [[nodiscard]] bool has_lesser_corners(const Located& a, const Located& b) const;
  [[nodiscard]] Point point_at(const Located& at) const;

  std::vector<Point> points_;
  std::vector<Leaf> leaves_;
  Array<Index> number_;     ///< the triangle of each leaf
  std::vector<Box> boxes_;  ///< an implicit binary tree: root at 1, leaves from leaf_count_ on
  std::size_t leaf_count_ = 1;
};

}  // namespace pardel::engine
