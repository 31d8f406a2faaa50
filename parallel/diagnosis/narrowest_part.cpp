#include "narrowest_part.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "../triangulation/triangle_shape.hpp"

namespace pardel::engine {
namespace {

/// Visits the triangles that are connected with `first` across edges, and marks them. Returns the width of this part.
double width_of_part(const Triangulation& t, TriangleId first, std::vector<bool>& is_visited) {
  double twice_area = 0, perimeter = 0;
  std::vector<TriangleId> waiting = {first};
  is_visited[first] = true;
  while (!waiting.empty()) {
    const Slot& slot = t.slots[waiting.back()];
    waiting.pop_back();
    const Shape shape(t, slot);
    twice_area += shape.twice_area;
    for (unsigned side = 0; side < 3; ++side) {
      const EdgeRef across = slot.n[side];
      if (across.none()) {
        perimeter += std::sqrt(shape.squared[side]);
      } else if (!is_visited[across.triangle()]) {
        is_visited[across.triangle()] = true;
        waiting.push_back(across.triangle());
      }
    }
  }
  return twice_area / perimeter;
}

}  // namespace

double narrowest_part(const DomainTriangulation& domain) {
  const Triangulation& t = domain.triangulation;
  std::vector<bool> is_visited(t.slots.size());
  double narrowest = INFINITY;
  for (TriangleId id = 0; id < t.slots.size(); ++id)
    if (!is_visited[id]) narrowest = std::min(narrowest, width_of_part(t, id, is_visited));
  return narrowest;
}

}  // namespace pardel::engine
