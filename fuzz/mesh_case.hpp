// Decodes bytes to a meshing problem. The bytes are a header, which selects the goal, the options and the outline, and
// strokes of eight bytes each: points, segments, fans, holes, regions, blocks of cocircular points. The outline may
// also be a domain of one of the families of the tests. Coordinates lie on a small integer lattice, so crossings,
// overlaps, touching holes, cocircular points and small angles are frequent; some points are moved off the lattice by a
// few units in the last place. repair() splits segments where they cross; no case is discarded because it is invalid.
//
// The mutator (mutate_strokes.cpp) inserts, removes, moves and exchanges whole strokes.
#pragma once

#include <cstdint>
#include <span>

#include "../core/goal.hpp"
#include "../core/pslg.hpp"
#include "../parallel/mesher.hpp"

namespace pardel::fuzz {

/// The header begins with the seed.
inline constexpr std::size_t seed_bytes = 4, header_bytes = 32, stroke_bytes = 8, most_strokes = 24;

struct MeshCase {
  Pslg pslg;  ///< before the repair: segments may cross and overlap
  Goal goal;
  Options options;
  bool nudged = false;        ///< some point was moved off the lattice
  bool refine_again = false;  ///< the result has to be refined for other bounds on areas, as `--refine` does
  int threads = 2;            ///< a second number of threads, 2 to 4
  int ranks = 2;              ///< a number of ranks, 2 to 5
  std::uint64_t seed = 0;     ///< 32 bits, for the choices of a target
  int mixture = 0;            ///< if not 0: a seed with which prepare() mixes scales
};

/// Deterministic. Every sequence of bytes gives a case, and so does every prefix.
[[nodiscard]] MeshCase decode_mesh_case(std::span<const std::uint8_t> bytes);

/// The repaired Pslg of a case, in which scales are mixed if the case says so. If the holes cover the whole domain, all
/// holes and regions are removed first.
struct Prepared {
  Pslg pslg;
  bool usable = false;   ///< false if the segments could not be repaired even without holes and regions
  bool reduced = false;  ///< true if the holes and regions were removed
  bool far_off = false;  ///< a component lies so far off that the shortest edges there can be a reason to miss a bound
};
[[nodiscard]] Prepared prepare(const MeshCase& drawn);

/// How many bytes decode_small_case() reads at most. What follows is free for a target.
inline constexpr std::size_t small_case_bytes = header_bytes + 5 * stroke_bytes;

/// The case of the first five strokes. For targets that compare with the definitions, which take cubic time.
[[nodiscard]] MeshCase decode_small_case(std::span<const std::uint8_t> bytes);

}  // namespace pardel::fuzz
