// Removal of the triangles outside a domain.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "../threads/threads.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// Defines which triangles belong to the domain: a triangle belongs to it unless a path that crosses no constraint
/// leads from the exterior or from a hole to the triangle.
struct DomainRules {
  bool convex_hull = false;  ///< the edges of the convex hull become constraints, so the exterior ends there
  std::vector<Point> holes;  ///< one point in each hole
  std::vector<Point> region_seeds;
};

/// Removes the ghosts, the exterior and the holes, and renumbers the remaining triangles from 0. If there are seeds,
/// sets Triangulation::region of each triangle to the index of the last seed from which it can be reached without
/// crossing a constraint, or to no_index. With convex_hull, returns the hull edges that became constraints. The number
/// of threads does not change the result. Before triangles of the exterior or of holes are removed, `look_at_outside`
/// is called with all of them and the ghosts.
[[nodiscard]] std::vector<Constraint> carve(
    Triangulation& t, const DomainRules& rules, const Threads& threads = {},
    const std::function<void(std::span<const TriangleId>)>& look_at_outside = [](auto) {});

}  // namespace pardel::engine
