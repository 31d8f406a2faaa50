// Domains on an integer lattice, drawn at random in named families, with their shrinkers. Integers, because then
// degeneracies (collinear, cocircular, touching) are exact and frequent, and because a smaller integer is simpler.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <vector>

#include "../../../core/pslg.hpp"
#include "random.hpp"

namespace pardel::generators {

/// What a domain is a hard case of; has_trait() says exactly.
enum class Family : std::uint8_t {
  general_position,  ///< no three points on a line, no four on a circle
  cocircular_grid,   ///< at least as many quadruples of cocircular points as points
  collinear_runs,    ///< three consecutive vertices of the boundary on a line
  near_duplicates,   ///< two points 2^9 times closer to each other than the domain is wide
  small_angles,      ///< an angle of the domain between two segments below 14.04 degrees (tangent 1/4)
  thin_channels,     ///< parallel segments side by side, closer than 1/20 of their length, the domain between them
  nested_holes,      ///< an island of the domain in a hole
  touching_holes,    ///< two holes, or a hole and the outside, that have a vertex in common
  cracks,            ///< a segment that ends inside the domain, with the domain on both sides
  isolated_points,   ///< a point in the domain that no segment ends at
  far_offset,        ///< further from the origin than 2^20 times its own width
};
[[nodiscard]] const std::vector<Family>& all_families();
[[nodiscard]] const char* name(Family family);

struct LatticePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend auto operator<=>(const LatticePoint&, const LatticePoint&) = default;
};

/// `seed` counts in quarters of the lattice's unit: every triangle of lattice points a, b, c holds the point
/// (2a + b + c) / 4, so that every face has a seed on that finer lattice.
struct LatticeRegion {
  LatticePoint seed;
  double attribute = 0;
  double max_area = std::numeric_limits<double>::infinity();  ///< in the lattice's units, > 0
  friend bool operator==(const LatticeRegion&, const LatticeRegion&) = default;
};

/// A Pslg whose point k lies at (points[k] + offset) * 2^-exponent.
struct LatticeDomain {
  Family family = Family::general_position;  ///< it was drawn for; what is shrunk may have lost the trait
  std::vector<LatticePoint> points;
  std::vector<Segment> segments;    ///< none: the domain is the convex hull of the points
  std::vector<LatticePoint> holes;  ///< in quarters, as regions' seeds
  std::vector<LatticeRegion> regions;
  LatticePoint offset;
  int exponent = 0;
  friend bool operator==(const LatticeDomain&, const LatticeDomain&) = default;
};

/// Bounds within which all arithmetic on lattices is exact, in integers and in doubles.
inline constexpr std::int64_t largest_lattice_coordinate = std::int64_t{1} << 26;
inline constexpr std::int64_t largest_offset = std::int64_t{1} << 49;
inline constexpr int largest_exponent = 64;  ///< in magnitude

/// All that RapidCheck prints of a failing domain: enough to write it down again.
std::ostream& operator<<(std::ostream& out, const LatticeDomain& domain);

/// Without any rounding. Segments have their markers, regions their attributes and caps (scaled by 4^-exponent).
/// Precondition: numbers within the bounds above.
[[nodiscard]] Pslg to_pslg(const LatticeDomain& domain);

/// Numbers are within the bounds above; points are distinct and not all on a line; segments meet at most in common
/// ends, run through no point, and close an outline where there are any; seeds lie off all segments, holes' inside
/// an outline, regions' in faces that remain, one in each; caps are positive; some face remains. By definition, in
/// exact integers; O(points * segments + segments^2).
[[nodiscard]] bool is_valid(const LatticeDomain& domain);

/// See Family. Precondition: is_valid(domain).
[[nodiscard]] bool has_trait(Family family, const LatticeDomain& domain);

/// A valid domain with the family's trait: 3 to 45 points, of which more come with the size, 0 to 100.
[[nodiscard]] LatticeDomain generate(Family family, Random& random, int size);
/// The families evenly.
[[nodiscard]] LatticeDomain any_domain(Random& random, int size);

/// What shrinking makes smaller: first the number of things, then what is odd about numbers, then their sizes.
/// Well-founded, since lexicographic in natural numbers.
struct Weight {
  std::uint64_t things = 0;     ///< points, segments, holes, regions
  std::uint64_t oddities = 0;   ///< an offset, an exponent, caps, attributes, markers
  std::uint64_t magnitude = 0;  ///< sum of the coordinates' magnitudes
  friend auto operator<=>(const Weight&, const Weight&) = default;
};
[[nodiscard]] Weight weight(const LatticeDomain& domain);

/// Simpler domains, the boldest first: without a hole and its ring, without a region, without segments, without a
/// point (an outline stays closed), on a coarser lattice, with no offset, no exponent, no caps. Each is valid and
/// weighs less. Precondition: is_valid(domain).
[[nodiscard]] std::vector<LatticeDomain> shrinks(const LatticeDomain& domain);

}  // namespace pardel::generators
