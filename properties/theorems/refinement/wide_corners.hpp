// Domains that Ruppert's proof covers: no two segments meet at less than 60 degrees. (No triangle is among them: its
// three angles would be 60 degrees each, and no triangle with rational coordinates is equilateral.)
#pragma once

#include <cstdint>
#include <ostream>
#include <vector>

#include "../../../core/pslg.hpp"
#include "../../domains/generators/random.hpp"

namespace pardel::properties {

/// What random_wide_corners() draws.
struct WideCorners {
  double least_radius = 8, most_radius = 14;  ///< of the circle around the outline
  int points = 4;                             ///< isolated points, at most
  bool points_at_sides = false;               ///< may a point lie close above the middle of a side of the outline?
  bool empty_ones = false;                    ///< are some domains squares and rhombi without anything in them?
};

/// A polygon in any direction: a rectangle, a parallelogram, a trapezoid, a house with a gable, an L, or a polygon of
/// five to eight sides. In it may be a hole or an island, three walls that meet at 120 degrees, or a free segment, and
/// isolated points. Coordinates are multiples of 1/4.
[[nodiscard]] Pslg random_wide_corners(generators::Random& random, const WideCorners& wanted);

/// How far the domain is from an axis-parallel square.
struct Corners60 {
  bool is_slanted = false;  ///< some segment is parallel to no axis
  bool is_sharp = false;    ///< two segments meet at less than 65 degrees
  bool has_hole = false;
  bool is_no_quadrangle = false;  ///< the outline or the hole has more than four sides
};
[[nodiscard]] Corners60 kind_of(const Pslg& pslg);

/// The same domain without one of its isolated points, for each of them.
[[nodiscard]] std::vector<Pslg> with_fewer_points(const Pslg& pslg);

}  // namespace pardel::properties

namespace pardel {

inline void showValue(const Pslg& pslg, std::ostream& out) {  // found by RapidCheck
  for (const Point& p : pslg.points) out << "(" << p.x << ", " << p.y << ") ";
  for (const Segment& s : pslg.segments) out << s.a << '-' << s.b << ' ';
  for (const Point& p : pslg.holes) out << "hole (" << p.x << ", " << p.y << ") ";
}

}  // namespace pardel
