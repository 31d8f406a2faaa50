// Axis-parallel rectangles.
#pragma once

#include <algorithm>
#include <cmath>

#include "../../core/pslg.hpp"

namespace pardel::engine {

/// An axis-parallel rectangle; by default the whole plane. The member functions state whether they treat it as closed
/// or as half-open.
struct Box {
  double min_x = -INFINITY, min_y = -INFINITY, max_x = INFINITY, max_y = INFINITY;

  /// The smallest closed box that contains both points.
  [[nodiscard]] static Box around(Point a, Point b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
  }
  [[nodiscard]] static Box around(Point p) { return {p.x, p.y, p.x, p.y}; }

  [[nodiscard]] bool is_whole_plane() const {
    return min_x == -INFINITY && min_y == -INFINITY && max_x == INFINITY && max_y == INFINITY;
  }
  /// True if p lies in [min_x, max_x) x [min_y, max_y).
  [[nodiscard]] bool contains_half_open(Point p) const {
    return p.x >= min_x && p.x < max_x && p.y >= min_y && p.y < max_y;
  }
  /// True if the two closed boxes have a point in common.
  [[nodiscard]] bool intersects_closed(const Box& other) const {
    return min_x <= other.max_x && other.min_x <= max_x && min_y <= other.max_y && other.min_y <= max_y;
  }
  /// The longer side.
  [[nodiscard]] double extent() const { return std::max(max_x - min_x, max_y - min_y); }
  /// The largest absolute value of a coordinate of the box.
  [[nodiscard]] double largest_magnitude() const {
    return std::max({std::abs(min_x), std::abs(min_y), std::abs(max_x), std::abs(max_y)});
  }
  /// Enlarges the box until it contains `other`.
  void cover(const Box& other) {
    min_x = std::min(min_x, other.min_x);
    min_y = std::min(min_y, other.min_y);
    max_x = std::max(max_x, other.max_x);
    max_y = std::max(max_y, other.max_y);
  }
};

/// Contains no point. Covering a box with it changes nothing.
inline constexpr Box empty_box{INFINITY, INFINITY, -INFINITY, -INFINITY};

}  // namespace pardel::engine
