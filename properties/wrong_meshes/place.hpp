// Place: where a drawing lies in the plane, and at which scale. Units: the spacing of doubles, as the definition of a
// valid mesh uses it.
#pragma once

#include "../../core/pslg.hpp"
#include "../domains/generators/random.hpp"

namespace pardel::wrong_meshes {

/// Maps the lattice of a drawing, small multiples of 1/16, to coordinates: turns it, moves it, and multiplies it by a
/// power of two. On lattice points this is exact.
struct Place {
  int exponent = 0;
  double right = 0, up = 0;  ///< how far the drawing is moved, before it is scaled
  bool mirrored = false, swapped = false;

  [[nodiscard]] Point at(double x, double y) const;
  /// A length of the lattice.
  [[nodiscard]] double length(double of_lattice) const;
};

/// A place at a power of two from 2^-120 to 2^150. No coordinate of a lattice point from 0 to 64 is zero. The drawing
/// is moved by less than 2^farthest; farthest is from 7 to 40.
[[nodiscard]] Place some_place(generators::Random& random, int farthest = 40);

/// A number from `least` to `greatest`, both positive. All magnitudes are equally likely.
[[nodiscard]] double some_magnitude(generators::Random& random, double least, double greatest);

/// The distance from |x| to the next larger double.
[[nodiscard]] double spacing(double x);

/// How far p lies from the line through a and b, in units of the segment ab.
[[nodiscard]] double distance_in_units(Point p, Point a, Point b);

/// A point near p that lies at least `units` units of ab off the line, and little more. `side` is 1 or -1. units <= 16.
[[nodiscard]] Point off_by_units(Point p, Point a, Point b, double units, int side);
/// A point near p that lies as far off the line as two units allow, or a little less.
[[nodiscard]] Point within_two_units(Point p, Point a, Point b, int side);
/// The point at this distance from p, at right angles to ab.
[[nodiscard]] Point off_by(Point p, Point a, Point b, double distance, int side);
/// The point a + share * (b - a), rounded; it lies within two units of the segment.
[[nodiscard]] Point between(Point a, Point b, double share);

}  // namespace pardel::wrong_meshes
