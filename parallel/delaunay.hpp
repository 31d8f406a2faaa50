// The Delaunay triangulation of points, with ghost triangles around the hull.
#pragma once

#include <span>
#include <vector>

#include "../core/result.hpp"
#include "triangulation.hpp"

namespace pardel {

/// Vertices are renumbered along a Hilbert curve, which keeps what is near in the plane near in memory.
struct Delaunay {
  Triangulation triangulation;         ///< ghosts included; origin and region are empty
  std::vector<Index> input_of_vertex;  ///< vertex -> index of the input point
};

/// Randomized incremental insertion in biased order (Amenta, Choi and Rote, "Incremental constructions con
/// BRIO", 2003): expected O(n log n) for any input, the randomness being a hash of the place along the curve, so
/// the result does not depend on the order of the input. Precondition: distinct points, coordinates in range; a
/// duplicate, or points that are all collinear, give invalid_input.
[[nodiscard]] Result<Delaunay> delaunay(std::span<const Point> points);

/// The non-ghost triangle that contains p, or a ghost triangle whose hull edge p lies beyond, found by a
/// visibility walk that takes the sides in pseudo-random order, from the non-ghost triangle `start`. It ends in
/// any constrained Delaunay triangulation with ghosts (with probability one; Devillers, Pion and Teillaud 2002).
[[nodiscard]] TriangleId locate(const Triangulation& t, Point p, TriangleId start);

}  // namespace pardel
