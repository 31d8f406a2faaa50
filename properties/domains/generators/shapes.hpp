// Contours that the families are drawn with, all counter-clockwise.
#pragma once

#include <vector>

#include "lattice_domain.hpp"
#include "random.hpp"

namespace pardel::generators {

using Contour = std::vector<LatticePoint>;

/// In [low, high] each.
[[nodiscard]] LatticePoint anywhere(Random& random, int low, int high);

[[nodiscard]] Contour box(LatticePoint corner, std::int64_t width, std::int64_t height);
/// A box with some of its corners cut off, each by less than a third of the shorter side. Convex.
[[nodiscard]] Contour cut_box(Random& random, LatticePoint corner, int width, int height);
/// An L in [0, side]^2; side >= 4.
[[nodiscard]] Contour angle_iron(Random& random, int side);
/// In [0, 2 radius]^2, star-shaped about (radius, radius), which is strictly inside; 4 to `corners` corners.
[[nodiscard]] Contour star(Random& random, int radius, int corners);
/// One of the above, or a triangle, in [0, side]^2; side >= 8.
[[nodiscard]] Contour any_outline(Random& random, int side, int corners);
/// A small triangle, box or diamond at this corner of its bounding box; sides 2 to `most`.
[[nodiscard]] Contour small_ring(Random& random, LatticePoint corner, int most);

}  // namespace pardel::generators
