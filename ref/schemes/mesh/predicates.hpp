// Exact predicates on points with double coordinates, from CGAL's filtered kernel. They are fast enough for meshes of a
// million triangles.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "../../../core/pslg.hpp"

namespace pardel::schemes {

using Filtered = CGAL::Exact_predicates_inexact_constructions_kernel;

[[nodiscard]] inline Filtered::Point_2 filtered(Point p) { return {p.x, p.y}; }

/// Positive if c lies on the left of the line from a to b, negative if it lies on the right, 0 if it lies on the line.
[[nodiscard]] inline int orientation(Point a, Point b, Point c) {
  return CGAL::orientation(filtered(a), filtered(b), filtered(c));
}

/// Does p lie strictly inside the circle through a, b and c? Precondition: orientation(a, b, c) > 0.
[[nodiscard]] inline bool in_circumdisk(Point a, Point b, Point c, Point p) {
  return CGAL::side_of_oriented_circle(filtered(a), filtered(b), filtered(c), filtered(p)) == CGAL::ON_POSITIVE_SIDE;
}

/// Does p encroach upon ab? That is, does it lie inside or on the circle with diameter ab, and is it neither a nor b?
[[nodiscard]] inline bool encroaches(Point p, Point a, Point b) {
  return p != a && p != b &&
         CGAL::side_of_bounded_circle(filtered(a), filtered(b), filtered(p)) != CGAL::ON_UNBOUNDED_SIDE;
}

}  // namespace pardel::schemes
