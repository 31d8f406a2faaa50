#include "insertion_order.hpp"

#include "../arithmetic/predicates.hpp"

namespace pardel::engine {

bool counts_as_inside(const Triangulation& t, const std::array<VertexId, 3>& v, VertexId fourth,
                      const InsertionOrder& order) {
  const Point a = t.points[v[0]], b = t.points[v[1]], c = t.points[v[2]], p = t.points[fourth];
  if (p == a || p == b || p == c) return false;
  const std::array<std::uint64_t, 3> time{order.time(v[0]), order.time(v[1]), order.time(v[2])};
  const auto latest = static_cast<unsigned>(std::ranges::max_element(time) - time.begin());
  if (order.time(fourth) > time[latest]) return false;
  // If the latest vertex is a corner, its greater height lifts the plane through the corners on its side of the line
  // through the other two. A point there is then below the plane, that is inside the circle.
  return orient2d(t.points[v[next_corner[latest]]], t.points[v[previous_corner[latest]]], p) > 0;
}

}  // namespace pardel::engine
