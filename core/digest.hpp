// A fingerprint of a mesh as a set: equal for equal meshes whatever the numbering of vertices and triangles.
#pragma once

#include <cstdint>
#include <string>

#include "mesh.hpp"

namespace pardel {

struct Digest {
  std::uint64_t high = 0;
  std::uint64_t low = 0;
  friend bool operator==(const Digest&, const Digest&) = default;
};

/// The sum modulo 2^128 of one 128-bit hash per triangle and one per constrained edge. A triangle's hash
/// is taken over the bits of its corners' coordinates (as exact doubles, -0 read as 0) in counter-clockwise
/// order starting at the lexicographically least corner, and over the bits of its region's attribute;
/// a constrained edge's over its two ends, least first, and its marker. Linear time, parallel; the sum
/// commutes, so threads do not change it.
[[nodiscard]] Digest digest(const Mesh& mesh);

/// 32 lower-case hexadecimal digits.
[[nodiscard]] std::string to_string(const Digest& digest);

}  // namespace pardel
