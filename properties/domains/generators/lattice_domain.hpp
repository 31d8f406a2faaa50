// Random domains on an integer lattice, in named families, with a shrinker. On integers, degeneracies (collinear
// points, cocircular points, touching holes) are exact and frequent, and a smaller integer is a simpler case.
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
#include "random.hpp"

namespace pardel::generators {

/// The families. Each stands for one trait that makes a domain difficult; has_trait() decides it.
enum class Family : std::uint8_t {
  general_position,  ///< no three points on a line, no four on a circle
  cocircular_grid,   ///< at least as many quadruples of cocircular points as points
  collinear_runs,    ///< three consecutive vertices of the boundary on a line
  near_duplicates,   ///< two points whose distance is at most 2^-9 of the width of the domain
  small_angles,      ///< an angle of the domain between two segments below 14.04 degrees (tangent 1/4)
  thin_channels,     ///< two parallel segments with the domain between them, closer than 1/20 of their length
  nested_holes,      ///< an island of the domain in a hole
  touching_holes,    ///< two holes, or a hole and the outside, that have a vertex in common
  cracks,            ///< a segment with a free end inside the domain
  isolated_points,   ///< a point inside the domain without a segment
  far_offset,        ///< at least 2^20 times its own width from the origin
};
/// In the order of the enumeration.
[[nodiscard]] const std::vector<Family>& all_families();
/// The enumerator: "cocircular_grid".
[[nodiscard]] const char* name(Family family);

struct LatticePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend auto operator<=>(const LatticePoint&, const LatticePoint&) = default;
};

/// A region. `seed` is in quarters of the lattice unit, because every triangle of lattice points a, b, c contains the
/// point (2a + b + c) / 4. So every face has a seed on that finer lattice.
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
  friend bool operator==(const LatticeDomain&, const LatticeDomain&) = default;
};

/// Bounds on magnitudes. Within them all arithmetic on lattices is exact, in integers and in doubles.
inline constexpr std::int64_t largest_lattice_coordinate = std::int64_t{1} << 26;
inline constexpr std::int64_t largest_offset = std::int64_t{1} << 49;
inline constexpr int largest_exponent = 64;

/// Prints everything that is needed to reconstruct the domain; for failing properties.
std::ostream& operator<<(std::ostream& out, const LatticeDomain& domain);

/// The Pslg, without rounding of coordinates. Area caps are scaled by 4^-exponent. Precondition: numbers are within the
/// bounds above.
[[nodiscard]] Pslg to_pslg(const LatticeDomain& domain);

/// True where to_pslg() gives a valid Pslg with a non-empty domain:
/// - numbers are within the bounds above; points are distinct and not all collinear;
/// - segments meet in common ends only and pass through no point; if there are any, they close an outline;
/// - seeds lie on no segment; holes lie inside an outline; regions lie in the domain, at most one in each face, with
///   positive caps.
/// Decided by definition in exact integers. O(points * segments + segments^2).
[[nodiscard]] bool is_valid(const LatticeDomain& domain);

/// True where the domain has the trait of the family, see Family. Precondition: is_valid(domain).
[[nodiscard]] bool has_trait(Family family, const LatticeDomain& domain);

/// A valid domain with the family's trait. `size`, from 0 to 100, controls the number of points: 3 to 45.
[[nodiscard]] LatticeDomain generate(Family family, Random& random, int size);
/// As above, with a random family; all families are equally likely.
[[nodiscard]] LatticeDomain any_domain(Random& random, int size);

/// The measure that shrinking reduces, in lexicographic order. It is well-founded, so shrinking ends.
struct Weight {
  std::uint64_t things = 0;     ///< points, segments, holes, regions
  std::uint64_t oddities = 0;   ///< how many of: offset, exponent, caps, attributes, markers
  std::uint64_t magnitude = 0;  ///< the sum of the magnitudes of all coordinates
  friend auto operator<=>(const Weight&, const Weight&) = default;
};
[[nodiscard]] Weight weight(const LatticeDomain& domain);

/// Simpler domains, largest steps first: without a hole and the ring around it, without a region, without segments,
/// without a point (outlines stay closed), on a coarser lattice, without offset, exponent, caps. Each result is valid
/// and has a smaller weight. Precondition: is_valid(domain).
[[nodiscard]] std::vector<LatticeDomain> shrinks(const LatticeDomain& domain);

}  // namespace pardel::generators
