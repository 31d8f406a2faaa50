// Computes a fingerprint of a mesh. It does not depend on the numbering of vertices, triangles and edges.
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

/// The sum modulo 2^128 of one 128-bit hash per triangle and one per constrained edge. Each hash is computed from a
/// sequence of 64-bit words. A coordinate or an attribute is one word, the bits of the double; -0 counts as 0.
///   triangle: x, y of its corners in their order (counter-clockwise in a valid mesh), starting at the
///             lexicographically least corner; then its region's attribute, 0 if it has no region. kind = 3.
///   edge:     x, y of its ends, the lexicographically least end first; then its marker as int64. kind = 2.
/// The hash of words w starts at h = mix(kind), l = mix(not kind), continues for each w with
///   h = mix(h xor w * 0x9e3779b97f4a7c15),  l = mix(l + w * 0xd1342543de82ef95 + 0x2545f4914f6cdd1d),
/// and ends as (high, low) = (mix(h + l), mix(l xor h * 0x9e3779b97f4a7c15)); mix is the finalizer of
/// splitmix64. The digest is not cryptographic: it detects differences, but not forgeries.
/// Linear time, on all threads. The result does not depend on the number of threads, because addition commutes.
/// Precondition: all indices are in range, as in the results of read_mesh and of the mesher.
[[nodiscard]] Digest digest(const Mesh& mesh);

/// The digest of a mesh whose two parts have these digests.
[[nodiscard]] Digest operator+(Digest a, const Digest& b);

/// 32 lower-case hexadecimal digits.
[[nodiscard]] std::string to_string(const Digest& digest);

}  // namespace pardel
