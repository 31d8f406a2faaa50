// Where the points and the walls of random scenes lie.
#pragma once

#include "scenes.hpp"

namespace pardel::properties {

/// The spacing of the points, in units of the lattice. On a square of side ten lie no lattice points but its corners
/// and others at (±1, ±7), (±7, ±1) and (±5, ±5) from its centre: there are positions that are cocircular with it.
inline constexpr int spacing = 10;

/// A layout of lines × lines points about, of a random family. The scattered one, whose circumradii are large, only
/// where separations do not matter.
[[nodiscard]] Scene random_points(generators::Random& random, int lines, bool scattered, Families& families);

/// Adds one to three of: cracks (open chains of short walls), closed loops, long walls that are no Delaunay edges.
void add_random_walls(generators::Random& random, Scene& scene, Families& families);

/// Does the wall run through no point of the scene and cross none of its walls?
[[nodiscard]] bool can_be_wall(const Scene& scene, const ref::Edge& wall);

/// The sign of the area of abc; exact where differences of coordinates are integers or halves below 2^25.
[[nodiscard]] int orientation(Point a, Point b, Point c);
/// Does p lie on the segment ab, its ends included? Exact as orientation.
[[nodiscard]] bool lies_on(Point p, Point a, Point b);

}  // namespace pardel::properties
