// Decodes bytes to a meshing problem. Every sequence of bytes gives an outline. The bytes select further segments,
// holes and regions. Coordinates lie on a small integer lattice, so crossings, overlaps, touching holes, cocircular
// points and small angles are frequent. repair() splits segments where they cross; no case is discarded because it is
// invalid.
#pragma once

#include <cstdint>
#include <span>

#include "../core/goal.hpp"
#include "../core/pslg.hpp"
#include "../parallel/mesher.hpp"

namespace pardel::fuzz {

struct MeshCase {
  Pslg pslg;  ///< before the repair: segments may cross and overlap
  Goal goal;
  Options options;
};

/// Deterministic. Every sequence of bytes gives a case, and so does every prefix.
[[nodiscard]] MeshCase decode_mesh_case(std::span<const std::uint8_t> bytes);

/// The repaired Pslg of a case. If the holes cover the whole domain, all holes and regions are removed first.
struct Prepared {
  Pslg pslg;
  bool usable = false;   ///< false if the segments could not be repaired even without holes and regions
  bool reduced = false;  ///< true if the holes and regions were removed
};
[[nodiscard]] Prepared prepare(const MeshCase& drawn);

}  // namespace pardel::fuzz
