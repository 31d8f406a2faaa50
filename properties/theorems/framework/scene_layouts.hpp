// Random positions for the points and walls of scenes.
#pragma once

#include "scenes.hpp"

namespace pardel::properties {

/// The spacing of the points, in units of the lattice. Relative to its centre, the circumcircle of a square of side 10
/// passes through the lattice points (±1, ±7), (±7, ±1) and (±5, ±5). So there are lattice positions that are
/// cocircular with the corners of the square.
inline constexpr int spacing = 10;

/// About lines × lines points, in a layout of a random family. The name of the family is appended to `families`. The
/// family "scattered" has large circumradii; it is chosen only if `scattered` is true.
[[nodiscard]] Scene random_points(generators::Random& random, int lines, bool scattered, Families& families);

/// Adds up to three groups of walls: cracks (open chains of short walls), closed loops, or long walls that are no edges
/// of the Delaunay triangulation.
void add_random_walls(generators::Random& random, Scene& scene, Families& families);

/// May the wall be added? That is, does it contain no other point of the scene and cross none of its walls?
[[nodiscard]] bool can_be_wall(const Scene& scene, const ref::Edge& wall);

/// The sign of the area of abc. Exact if differences of coordinates are multiples of 1/2 below 2^25.
[[nodiscard]] int orientation(Point a, Point b, Point c);
/// Does p lie on the closed segment ab? Exact under the same condition as orientation().
[[nodiscard]] bool lies_on(Point p, Point a, Point b);

}  // namespace pardel::properties
