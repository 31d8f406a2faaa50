// Points at which a triangle may be split instead of at its off-centre.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "../triangulation/triangle_shape.hpp"

namespace pardel::engine {

inline constexpr std::size_t candidates_per_circle = 16, candidate_circles = 3;
using CandidateCircle = std::array<Point, candidates_per_circle>;

/// Points on circles around the circumcentre, with a quarter, a half and three quarters of the circumradius. They lie
/// in the open circumdisk, so each of them removes the triangle. The smallest circle comes first: its points are the
/// farthest from the corners. On each circle, the first point lies towards the corner opposite the shortest side.
[[nodiscard]] std::array<CandidateCircle, candidate_circles> split_candidates(const Shape& shape);

/// A candidate is taken only if all vertices that it is connected to are at least so far away. The least of the
/// circumradius and the shortest side is the distance that a circumcentre keeps. Points that are
/// nearer make larger meshes, and far nearer ones make the refinement go on to the shortest edges allowed.
[[nodiscard]] inline double least_squared_distance(const Measure& m) {
  // Measured: with 0.65, refinement at 33 degrees runs through meshes of equilateral triangles. With less than 0.5, it
  // goes on to the shortest edges allowed.
  constexpr double part = 0.6;
  return part * std::min(m.squared_circumradius(), m.shortest_squared());
}

}  // namespace pardel::engine
