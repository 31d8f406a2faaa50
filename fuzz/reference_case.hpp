// Decodes bytes to a meshing problem that Ruppert's algorithm is proven to solve.
#pragma once

#include <cstdint>
#include <span>

#include "../core/goal.hpp"
#include "../core/pslg.hpp"

namespace pardel::fuzz {

/// A square of side 16, possibly with a rectangular hole or island, or a wall from side to side, and isolated points.
/// It may have far points around it, or a copy beside it, in its hole or in a face, up to 2^60 times smaller; then it
/// is multiplied by a power of two. No two segments meet at less than 60 degrees.
struct ReferenceCase {
  Pslg pslg;
  Goal goal;
};

/// Deterministic. Every sequence of bytes gives a case, and so does every prefix.
[[nodiscard]] ReferenceCase decode_reference_case(std::span<const std::uint8_t> bytes);

}  // namespace pardel::fuzz
