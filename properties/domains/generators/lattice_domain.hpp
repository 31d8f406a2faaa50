// Random domains on an integer lattice, in named families, with a shrinker. On integers, degeneracies (collinear
// points, cocircular points, touching holes) are exact and frequent, and a case is simpler if its integers are smaller.
//
//     pardel::generators::Random random(seed);
//     const auto domain = pardel::generators::generate(Family::cracks, random, 50);
//     const pardel::Pslg pslg = to_pslg(domain);
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <vector>

#include "../../../core/pslg.hpp"
#include "decorations.hpp"
#include "random.hpp"

namespace pardel::generators {

/// The families. Each family has one trait that makes a domain difficult; has_trait() tests for it.
enum class Family : std::uint8_t {
  general_position,  ///< no three points on a line, no four on a circle
  cocircular_grid,   ///< at least as many quadruples of cocircular points as points
  collinear_runs,    ///< three consecutive vertices of the boundary on a line
  near_duplicates,   ///< two points whose distance is at most 2^-9 of the width of the domain
  small_angles,      ///< an angle of the domain between two segments below 14.04 degrees (tangent 1/4)
  thin_channels,     ///< two parallel segments with the domain between them, less than 1/20 of their length apart
  nested_holes,      ///< an island of the domain in a hole
  touching_holes,    ///< two holes, or a hole and the outside, that have a vertex in common
  cracks,            ///< a segment with a free end inside the domain
  isolated_points,   ///< a point inside the domain without a segment
  far_offset,        ///< the distance from the origin is at least 2^20 times the width of the domain
};
/// All families, in the order of the enumeration.
[[nodiscard]] const std::vector<Family>& all_families();
/// The name of the enumerator, for example "cocircular_grid".
[[nodiscard]] const char* name(Family family);

struct LatticePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend auto operator<=>(const LatticePoint&, const LatticePoint&) = default;
};

/// A region. `seed` is in quarters of the lattice unit: every triangle of lattice points a, b, c contains the point
/// (2a + b + c) / 4, so every face contains a point whose coordinates are multiples of 1/4.
struct LatticeRegion {
  LatticePoint seed;
  double attribute = 0;
  double max_area = std::numeric_limits<double>::infinity();  ///< in lattice units, > 0
  friend bool operator==(const LatticeRegion&, const LatticeRegion&) = default;
};

/// A Pslg on the lattice. Its point k lies at (points[k] + offset) * 2^-exponent.
struct LatticeDomain {
  Family family = Family::general_position;  ///< the family it was generated for; a shrunk domain may lack the trait
  std::vector<LatticePoint> points;
  std::vector<Segment> segments;    ///< empty: the domain is the convex hull of the points
  std::vector<LatticePoint> holes;  ///< seeds, in quarters of the lattice unit
  std::vector<LatticeRegion> regions;
  LatticePoint offset;
  int exponent = 0;
  Decorations decorations;
  friend bool operator==(const LatticeDomain&, const LatticeDomain&) = default;
};

/// Bounds on magnitudes. Within them all arithmetic on lattices is exact, in integers and in doubles.
inline constexpr std::int64_t largest_lattice_coordinate = std::int64_t{1} << 26;
inline constexpr std::int64_t largest_offset = std::int64_t{1} << 49;
inline constexpr int largest_exponent = 64;

/// Prints everything that is needed to reconstruct the domain. Reports of failed properties contain this text.
std::ostream& operator<<(std::ostream& out, const LatticeDomain& domain);

/// The Pslg with its decorations, without rounding of coordinates. Area caps are scaled by 4^-exponent. Precondition:
/// numbers are within the bounds above.
[[nodiscard]] Pslg to_pslg(const LatticeDomain& domain);

/// True if to_pslg() gives a valid Pslg with a non-empty domain:
/// - numbers are within the bounds above; points are distinct and not all collinear;
/// - segments meet in common ends only and pass through no point; if there are segments, some form a closed outline;
/// - seeds lie on no segment; holes lie inside an outline; regions lie in the domain, at most one in each face, with
///   positive caps.
/// The function follows this definition literally, in exact integers. O(points * segments + segments^2).
[[nodiscard]] bool is_valid(const LatticeDomain& domain);

/// True if the domain has the trait of the family, see Family. Precondition: is_valid(domain).
[[nodiscard]] bool has_trait(Family family, const LatticeDomain& domain);

/// A valid domain with the family's trait. `size`, from 0 to 100, controls the number of points: 3 to 45.
[[nodiscard]] LatticeDomain generate(Family family, Random& random, int size);
/// A domain as by generate(), of a random family, with any decorations. All families are equally likely.
[[nodiscard]] LatticeDomain any_domain(Random& random, int size);

/// The measure that every shrinking step reduces, in lexicographic order. The order is well-founded, so shrinking ends.
struct Weight {
  std::uint64_t things = 0;  ///< the number of points, segments, holes and regions
  std::uint64_t oddities =
      0;  ///< the number of finite caps, decorations, and non-zero offsets, exponents, attributes, markers
  std::uint64_t magnitude = 0;  ///< the sum of the magnitudes of all coordinates
  friend auto operator<=>(const Weight&, const Weight&) = default;
};
[[nodiscard]] Weight weight(const LatticeDomain& domain);

/// Simpler domains, those that differ most first: a hole is removed with the segments around it, a region, segments or
/// a point are removed (outlines stay closed), the lattice becomes coarser, the offset, the exponent, caps or a
/// decoration are removed. Each result is valid and has a smaller weight. Precondition: is_valid(domain).
[[nodiscard]] std::vector<LatticeDomain> shrinks(const LatticeDomain& domain);

}  // namespace pardel::generators
