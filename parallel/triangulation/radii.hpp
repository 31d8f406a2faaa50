// Circumradii: the bounds that follow from ratio and area, and the largest values in a mesh.
#pragma once

#include "../threads/index_allocator.hpp"
#include "../threads/threads.hpp"
#include "triangulation.hpp"

namespace pardel::engine {

/// A bound on the circumradius by theorem T3 (THEORY.md). `ratio` is a bound on circumradius / shortest edge, and
/// `area` a bound on the area.
[[nodiscard]] double radius_bound(double ratio, double area);
/// The least such bound (THEORY.md, T3-sharp). Precondition: ratio > 1/2, as in every triangle.
[[nodiscard]] double sharp_radius_bound(double ratio, double area);

/// The largest circumradius, ratio and area of a set of triangles, up to rounding. They may be of different triangles.
struct Radii {
  double radius = 0, ratio = 0, area = 0;
};
/// The largest values over the triangles whose indices are in use. Precondition: the allocator is settled. O(n).
[[nodiscard]] Radii largest_radii(const Triangulation& t, const IndexAllocator& triangles, const Threads& threads);

}  // namespace pardel::engine
