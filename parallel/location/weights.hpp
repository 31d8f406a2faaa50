// Barycentric coordinates, and the interpolation of values with them.
#pragma once

#include <array>
#include <span>

#include "located_triangles.hpp"

namespace pardel::engine {

/// The barycentric coordinates of a point in the triangle of these corners: accurate to a few units in the last place
/// of 1, also in the thinnest triangles; 0 exactly for the corners opposite the edges on which the point lies.
/// Preconditions: the triangle contains the point, and is not flat.
[[nodiscard]] std::array<double, 3> weights_in(const std::array<Point, 3>& corners, Point p);

/// The value at these coordinates of the linear function with these values at the corners: between them, and exactly
/// theirs at a corner, and where they are equal.
[[nodiscard]] double blend(const std::array<double, 3>& weights, const std::array<double, 3>& values);

}  // namespace pardel::engine
