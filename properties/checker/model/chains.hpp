// Chains: the mesh edges that the segments of the domain have become.
#pragma once

#include <cstdint>
#include <vector>

#include "../../../core/mesh.hpp"
#include "adjacency.hpp"
#include "domain.hpp"
#include "input_vertices.hpp"

namespace pardel::checker {

/// A mesh edge on a segment, in the direction of the segment, with the triangles on its two sides.
struct ChainEdge {
  Index from, to;
  Index segment;  ///< of Domain::segments()
  TriangleEdge left, right;
};

struct Chains {
  std::vector<ChainEdge> edges;  ///< by segment, and along each in order
  Array<Index> segment_of;       ///< per vertex: the segment in whose interior it was put, no_index for others
  Array<std::uint8_t> on_chain;  ///< per triangle: bit i is set where edge i lies on a chain
  std::vector<Index> broken;     ///< segments of the domain without a chain

  [[nodiscard]] bool has(Index triangle, int edge) const { return (on_chain[triangle] >> edge & 1) != 0; }
};

/// How near to its segment the next vertex of a chain has to be.
enum class Strictness : std::uint8_t {
  rounding,  ///< within Domain::tolerance()
  likeness,  ///< within a millionth of the segment's length, or said to be put on it: tells a bent chain from none
};

/// Walks from one end of a segment to the other along mesh edges, always forward and never through another
/// input vertex. Edges run from the segment's end a to b; empty when there is no way. Looks at nothing but
/// coordinates and triangles (origins only break ties between equally good edges).
[[nodiscard]] std::vector<ChainEdge> walk_chain(Index segment, const Domain& domain, const Mesh& mesh,
                                                const Adjacency& adjacency, const InputVertices& inputs,
                                                Strictness strictness);

}  // namespace pardel::checker
