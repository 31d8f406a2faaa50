// A meshing problem out of bytes. Whatever the bytes are, the result has an outline, and segments, holes and
// regions in it wherever the bytes ask for them: coordinates lie on a small integer lattice, so that crossings,
// overlaps, touching holes, cocircular points and small angles happen all the time, and repair() turns what
// crosses into what meets. Nothing is thrown away to make a case valid.
#pragma once

#include <cstdint>
#include <span>

#include "../core/goal.hpp"
#include "../core/pslg.hpp"
#include "../parallel/mesher.hpp"

namespace pardel::fuzz {

struct MeshCase {
  Pslg pslg;  ///< as drawn: may cross and overlap itself
  Goal goal;
  Options options;
};

/// Deterministic; total; every prefix of the bytes means a case too.
[[nodiscard]] MeshCase decode_mesh_case(std::span<const std::uint8_t> bytes);

/// The case's Pslg made valid, without its holes and regions only where these leave no domain (`reduced`).
struct Prepared {
  Pslg pslg;
  bool usable = false;  ///< false: not even the bare lines could be repaired
  bool reduced = false;
};
[[nodiscard]] Prepared prepare(const MeshCase& drawn);

}  // namespace pardel::fuzz
