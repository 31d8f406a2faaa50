#include "on_walls.hpp"

#include <algorithm>

#include "../../../ref/insertion.hpp"
#include "shares.hpp"

namespace pardel::properties {

SplitEdge split_edge_at(const ref::PlainMesh& mesh, const ref::ExactPoint& p) {
  const auto contains = [&](const ref::Edge& e) {
    return CGAL::are_strictly_ordered_along_line(mesh.points[e[0]], p, mesh.points[e[1]]);
  };
  return {ref::constraint_through(mesh, p).has_value(), std::ranges::any_of(border_of(mesh), contains)};
}

void classify_on_walls(const ref::PlainMesh& mesh, const std::vector<ref::ExactPoint>& insertions,
                       const ShareOnWalls& least) {
  int inside = 0, border = 0;
  for (const ref::ExactPoint& p : insertions) {
    const SplitEdge split = split_edge_at(mesh, p);
    if (split.is_wall) ++(split.is_border ? border : inside);
  }
  classify(inside > 0, "an insertion splits a wall inside the domain", least.inside);
  classify(border > 0, "an insertion splits a wall of the border", least.border);
  if (least.two > 0) classify(inside + border >= 2, "two insertions split walls", least.two);
}

}  // namespace pardel::properties
