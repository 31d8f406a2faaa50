// Named domains: inputs that demos, tests, benchmarks and fuzzing share. All are valid Pslgs.
//
// Every function returns the same Pslg on every platform. Random numbers come from SplitMix64 (generators/random.hpp).
// Computed coordinates are rounded to multiples of 2^-30, because the last bit of a sine differs between platforms.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "../../core/pslg.hpp"
#include "../../core/result.hpp"

namespace pardel::domains {

/// The unit square, 4 segments.
[[nodiscard]] Pslg square();

/// The cross-section of a pipe, as in the paper (Chernikov and Chrisochoides 2004): an outer circle of radius 1 (200
/// segments), a central hole of radius 0.35 and six holes of radius 0.12 at distance 0.67 from the centre (60 segments
/// each). Markers 1, 2 and 3.
[[nodiscard]] Pslg pipe();

/// A door key, similar to Figure 2 of the paper: a bow with a ring hole, a shaft, teeth and arcs. At least 150
/// segments. Markers: 1 (outline), 2 (ring hole) and 3 (hole in the bit). Lengths are in centimetres.
[[nodiscard]] Pslg key();

/// n points, uniform in the unit square, without segments. Coordinates are multiples of 2^-40. Linear time.
[[nodiscard]] Pslg random_points(std::uint64_t n, std::uint64_t seed);

/// n points of the Kuzmin distribution, without segments: dense around the origin, with a share of 1/r of them farther
/// than about r away. Linear time, as for the next two.
[[nodiscard]] Pslg kuzmin_points(std::uint64_t n, std::uint64_t seed);

/// n points in the unit square, most of them close to its lower side, without segments: the distribution "line" of
/// Blelloch, Hardwick, Miller and Talmor, "Design and implementation of a practical parallel Delaunay algorithm", 1999.
[[nodiscard]] Pslg line_points(std::uint64_t n, std::uint64_t seed);

/// n points in 100 clusters around the unit square, whose radii range from 2^-5 to 2^-15, without segments.
[[nodiscard]] Pslg clustered_points(std::uint64_t n, std::uint64_t seed);

/// A survey of a lake: n points, uniform in a square with sides of length 2, in and around a shore of 400 segments
/// (marker 1) with an island of 100 segments (marker 2), and a line of three segments on the ground (marker 3).
[[nodiscard]] Pslg survey(std::uint64_t n, std::uint64_t seed);

/// A bay with 16 islands: n >= 96 points, all on outlines. Half of them are on the shore of the bay (marker 1), the
/// others on those of the islands (marker 2). The outlines are rough on all scales.
[[nodiscard]] Pslg coast(std::uint64_t n, std::uint64_t seed);

/// A star with `spikes` >= 3 spikes on the unit circle. Each tip has an angle of `spike_degrees`, above 0 and below
/// 180.
[[nodiscard]] Pslg star(int spikes, double spike_degrees);

/// A bar of length 1 and height 1/4. On top of it stand `teeth` >= 1 thin channels of width `gap`, up to height 1.
/// Precondition: 0 < gap < 1 / teeth.
[[nodiscard]] Pslg comb(int teeth, double gap);

/// `segments` >= 1 segments of length 1 from the origin, with angles of `degrees_apart` degrees between them, in a box
/// with sides of length 4. Further segments join the ends of the first half of them. Precondition:
/// segments * degrees_apart <= 360.
[[nodiscard]] Pslg wedge(int segments, double degrees_apart);

/// (n + 1)^2 points of the unit lattice. All lattice edges and one diagonal of each cell are segments.
[[nodiscard]] Pslg grid(int n);

/// The points of grid(n) without segments: the four corners of every cell lie on a circle.
[[nodiscard]] Pslg grid_points(int n);

/// Two square holes that touch in a corner, and a third hole that touches a corner of the outline.
[[nodiscard]] Pslg touching_holes();

/// Segments with one or two free ends and isolated points in a square with sides of length 4.
[[nodiscard]] Pslg cracks();

/// A rectangle of 3 by 1 in three regions with attributes 10, 20, 30 and area caps 2^-6, 2^-9, 2^-5.
[[nodiscard]] Pslg regions();

/// A square with sides of length 2, its centre, and 24 `decades` rings of 24 points around it, whose radii grow by the
/// same factor from 0.95e-`decades` to 0.95. For graded meshes. Precondition: 1 <= decades <= 6.
[[nodiscard]] Pslg radial(int decades);
/// Wanted edge lengths at the points of radial(): `ratio` times the distance from the centre; at the centre, the length
/// of the innermost ring.
[[nodiscard]] std::vector<double> radial_sizes(const Pslg& radial, double ratio);

/// Every point p, hole and seed becomes scale * p + (dx, dy), in doubles; area caps are multiplied by scale^2. For
/// tests of coordinates far from the origin, such as (654321, 4987654). The result is valid only if different points
/// stay different after rounding.
[[nodiscard]] Pslg moved(Pslg pslg, double dx, double dy, double scale = 1);

/// The domain that `pardel generate NAME` writes. Arguments: a name from names(), and a size n and a seed for domains
/// that have them; n = 0 means the default size. ErrorKind::usage for an unknown name or a size out of range; the
/// message lists the names or the range.
[[nodiscard]] Result<Pslg> generate(std::string_view name, std::uint64_t n, std::uint64_t seed);

/// The sizes that a domain of generate() can have.
struct SizeRange {
  std::string name;
  std::uint64_t least, most, usual;
};
/// Of the domains that have a size.
[[nodiscard]] std::vector<SizeRange> size_ranges();

/// The names that generate() accepts.
[[nodiscard]] std::vector<std::string> names();

/// The names without the unevenly spread points: domains with sides of at most some units, whose distances between
/// points are large enough for coordinates far from the origin.
[[nodiscard]] std::vector<std::string> even_names();

}  // namespace pardel::domains
