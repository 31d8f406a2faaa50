// Bounds on circumradii: what ratio and area promise, and what a mesh has.
#pragma once

#include "../concurrency/index_allocator.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// T3: a bound on the circumradius where `ratio` bounds circumradius over shortest edge and `area` the area.
[[nodiscard]] double radius_bound(double ratio, double area);
/// T3-sharp: the least such bound.
[[nodiscard]] double sharp_radius_bound(double ratio, double area);

/// The largest of each over all triangles, to rounding.
struct Radii {
  double radius = 0, ratio = 0, area = 0;
};
/// Of the triangles whose numbers are in use. O(n).
[[nodiscard]] Radii largest_radii(const Triangulation& t, const IndexAllocator& triangles, int threads);

}  // namespace pardel::engine
