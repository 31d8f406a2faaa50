// Contours (closed polygons) from which the generators of the families build domains. All are counter-clockwise.
#pragma once

#include <vector>

#include "../lattice_domain.hpp"
#include "../random.hpp"

namespace pardel::generators {

using Contour = std::vector<LatticePoint>;

/// A random point; both coordinates are in [low, high].
[[nodiscard]] LatticePoint anywhere(Random& random, int low, int high);

[[nodiscard]] Contour box(LatticePoint corner, std::int64_t width, std::int64_t height);
/// A convex polygon: a box with some corners cut off, each by less than a third of the shorter side.
[[nodiscard]] Contour cut_box(Random& random, LatticePoint corner, int width, int height);
/// An L-shaped polygon in [0, side]^2. Precondition: side >= 4.
[[nodiscard]] Contour angle_iron(Random& random, int side);
/// A polygon in [0, 2 radius]^2 with 4 to `corners` corners, star-shaped about (radius, radius), which is strictly
/// inside.
[[nodiscard]] Contour star(Random& random, int radius, int corners);
/// A box, a cut box, an angle iron, a star or a triangle, in [0, side]^2. Precondition: side >= 8.
[[nodiscard]] Contour any_outline(Random& random, int side, int corners);
/// A triangle, box or diamond. `corner` is the lower left corner of its bounding box. The sides of the bounding box
/// have lengths from 2 to `most`.
[[nodiscard]] Contour small_ring(Random& random, LatticePoint corner, int most);

}  // namespace pardel::generators
