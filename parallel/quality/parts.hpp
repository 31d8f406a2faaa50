// Parts of a triangle, for estimates of the work in it. In a large triangle of the input, the size at the centroid says
// little about the sizes elsewhere.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "../triangulation/triangle_shape.hpp"
#include "criteria.hpp"

namespace pardel::engine {

/// How often triangles have to be divided into four, so that this number of triangles gives enough samples of a size
/// that depends on the place. A test of the user may be slow, and gets fewer samples.
[[nodiscard]] inline int divisions_for(const Criteria& criteria, std::size_t triangles) {
  const std::size_t enough = criteria.has_user_test() ? 64 : 4096;
  int divisions = 0;
  if (!criteria.depends_on_place() || triangles == 0) return divisions;
  while (triangles << 2 * divisions < enough) ++divisions;
  return divisions;
}

/// Calls visit(part) for the 4^divisions parts of a triangle, which are similar to it, and equally large.
template <class Visit>
void visit_parts(const Shape& whole, int divisions, const Visit& visit) {
  if (divisions == 0) return visit(whole);
  const int n = 1 << divisions;
  // Rounding must not put a point beyond the triangle's bounding box: a field of sizes may end there.
  const auto mixed = [n](double a, double b, double c, int i, int j) {
    return std::clamp((a * (n - i - j) + b * i + c * j) / n, std::min({a, b, c}), std::max({a, b, c}));
  };
  const std::array<Point, 3>& p = whole.p;
  const auto at = [&](int i, int j) {
    return Point{mixed(p[0].x, p[1].x, p[2].x, i, j), mixed(p[0].y, p[1].y, p[2].y, i, j)};
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n - i; ++j) {
      visit(Shape(at(i, j), at(i + 1, j), at(i, j + 1)));
      if (i + j + 1 < n) visit(Shape(at(i + 1, j + 1), at(i, j + 1), at(i + 1, j)));
    }
}

/// Announces the centroids of the parts of the triangles from `first` to before `last`, of which each has 4^divisions
/// parts. Precondition: criteria.announces_places().
inline void announce_parts(const Criteria& criteria, const Triangulation& t, std::size_t first, std::size_t last,
                           int divisions) {
  std::vector<Point> places;
  for (std::size_t id = first; id < last; ++id)
    visit_parts(Shape(t, t.slots[id]), divisions, [&](const Shape& part) { places.push_back(part.centroid()); });
  criteria.announce(places);
}

}  // namespace pardel::engine
