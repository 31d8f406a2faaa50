#include "area_caps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../../core/support/doubled_area.hpp"
#include "../../parallel/arithmetic/distance.hpp"
#include "../../parallel/triangulation/triangle_shape.hpp"

namespace pardel::engine {
namespace {

constexpr double stricter = 1 - 0x1p-40;
/// The area of an equilateral triangle with sides of length 1.
constexpr double equilateral = 0.43301270189221935;

/// `edge`: the longest edge allowed.
double cap_for_edge(double edge, Point a, Point b, Point c) {
  const double cap = equilateral * edge * edge;
  const bool too_long = std::max({distance(a, b), distance(b, c), distance(c, a)}) > edge;
  return too_long ? std::min(cap, 0.5 * doubled_area(a, b, c)) : cap;
}

}  // namespace

std::vector<double> area_caps(const Subdomain& subdomain) {
  const Goal& goal = subdomain.goal;
  std::vector<double> caps = subdomain.max_areas;
  caps.resize(subdomain.triangles.size(), INFINITY);
  for (std::size_t t = 0; t < caps.size(); ++t) {
    const auto [i, j, k] = subdomain.triangles[t];
    const Point a = subdomain.points[i], b = subdomain.points[j], c = subdomain.points[k];
    double edge = goal.max_edge;
    if (goal.size) edge = std::min(edge, goal.size(centroid_of(a, b, c)));
    caps[t] = stricter * std::min({caps[t], goal.max_area, cap_for_edge(edge, a, b, c)});
    caps[t] = std::max(caps[t], std::numeric_limits<double>::min());  // of a flat triangle it could be 0
  }
  return caps;
}

}  // namespace pardel::engine
