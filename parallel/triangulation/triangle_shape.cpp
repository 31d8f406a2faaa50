#include "triangle_shape.hpp"

#include "../arithmetic/predicates.hpp"

namespace pardel::engine {
namespace {

double squared_distance(Point p, Point q) { return (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y); }

}  // namespace

Measure measure_of_thin(Point a, Point b, Point c) {
  return {{squared_distance(b, c), squared_distance(c, a), squared_distance(a, b)}, exact::twice_area(a, b, c)};
}

}  // namespace pardel::engine
