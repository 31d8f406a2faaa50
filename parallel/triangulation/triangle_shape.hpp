// The measure of a triangle (its squared side lengths and its area), for one triangle or for two at once; its shape
// (the measure with the corners); and its least corner.
#pragma once

#include <algorithm>
#include <array>

#include "../../core/pslg.hpp"
#include "../../core/support/point_order.hpp"
#include "../arithmetic/pair.hpp"
#include "../arithmetic/predicates.hpp"
#include "triangulation.hpp"

namespace pardel::engine {

/// The lengths and the area that determine the quality of a triangle. T is double, or Pair for two triangles at
/// once.
template <class T>
struct MeasureOf {
  std::array<T, 3> squared{};  ///< squared length of the side opposite each corner
  T twice_area{};

  [[nodiscard]] T shortest_squared() const { return least(least(squared[0], squared[1]), squared[2]); }
  [[nodiscard]] T longest_squared() const { return greatest(greatest(squared[0], squared[1]), squared[2]); }
  [[nodiscard]] T middle_squared() const {
    const T low = least(squared[0], squared[1]), high = greatest(squared[0], squared[1]);
    return greatest(low, least(high, squared[2]));
  }
  [[nodiscard]] T squared_circumradius() const {
    return squared[0] * (squared[1] / twice_area) * (squared[2] / twice_area) / 4;
  }
  /// The shortest side. The smallest angle lies at the corner of the same number.
  [[nodiscard]] unsigned shortest_side() const {
    const auto second = static_cast<unsigned>(squared[1] < squared[0]);
    const auto third = static_cast<unsigned>(squared[2] < least(squared[0], squared[1]));
    return third << 1U | (second & ~third);
  }
  /// The scalar product (b - a) . (c - a), where a is the corner and b, c are the other two.
  [[nodiscard]] T dot_at(unsigned corner) const {
    return 0.5 * (squared[next_corner[corner]] + squared[previous_corner[corner]] - squared[corner]);
  }
};
using Measure = MeasureOf<double>;

/// A measure is computed from the differences of two corners to the third. If twice the area is at least this share of
/// the sum of the squares of these two sides, its relative error is below 2^-40, and so are those of the lengths.
inline constexpr double share_of_thin = 0x1p-12;
/// The measure of a triangle, however thin it is, with equally small errors.
[[nodiscard, gnu::cold]] inline Measure measure_of_thin(Point a, Point b, Point c) {
  const auto squared = [](Point p, Point q) { return (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y); };
  return {{squared(b, c), squared(c, a), squared(a, b)}, exact::twice_area(a, b, c)};
}

[[nodiscard]] inline Point centroid_of(Point a, Point b, Point c) {
  return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
}

/// The lexicographically least corner. It does not depend on numbers or on which corner is the first one, so all ranks
/// agree on it. Precondition: the triangle is no ghost.
[[nodiscard]] inline VertexId least_corner(const Triangulation& t, const Slot& triangle) {
  const auto less = [&](VertexId a, VertexId b) { return lexicographically_less(t.points[a], t.points[b]); };
  return std::min({triangle.v[0], triangle.v[1], triangle.v[2]}, less);
}

/// The vector from a corner of a triangle to its circumcentre. `b`, `c`: the vectors from this corner to the others,
/// counter-clockwise.
[[nodiscard]] inline Point to_circumcentre(Point b, Point c, double twice_area) {
  const double b2 = b.x * b.x + b.y * b.y, c2 = c.x * c.x + c.y * c.y, scale = 0.5 / twice_area;
  return {(b2 * c.y - c2 * b.y) * scale, (c2 * b.x - b2 * c.x) * scale};
}

/// The corners of a triangle with its measure.
struct Shape : Measure {
  std::array<Point, 3> p;

  Shape(const Triangulation& t, const Slot& slot)
      : Shape(t.points[slot.v[0]], t.points[slot.v[1]], t.points[slot.v[2]]) {}
  /// The measure is computed from the differences to the first corner, unless the triangle is thin. An insertion
  /// computes it in the same way (Insertion::measures), so both results have the same bits.
  Shape(Point a, Point b, Point c) : p{a, b, c} {
    const double abx = b.x - a.x, aby = b.y - a.y;
    const double acx = c.x - a.x, acy = c.y - a.y;
    const double bcx = acx - abx, bcy = acy - aby;
    squared = {bcx * bcx + bcy * bcy, acx * acx + acy * acy, abx * abx + aby * aby};
    twice_area = abx * acy - aby * acx;
    if (!(twice_area >= share_of_thin * (squared[1] + squared[2]))) [[unlikely]]
      static_cast<Measure&>(*this) = measure_of_thin(a, b, c);
  }

  [[nodiscard]] Point centroid() const { return centroid_of(p[0], p[1], p[2]); }
};

}  // namespace pardel::engine
