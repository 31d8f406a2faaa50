// Chains: for each segment of the domain the sequence of mesh edges that it became.
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
  Index segment;  ///< index into Domain::segments()
  TriangleEdge left, right;
};

struct Chains {
  std::vector<ChainEdge> edges;  ///< by segment, and in order along each segment
  Array<Index> segment_of;       ///< per vertex: the segment whose interior contains it, or no_index
  Array<std::uint8_t> on_chain;  ///< per triangle: bit i is set where edge i belongs to a chain
  std::vector<Index> broken;     ///< segments of the domain without a chain

  [[nodiscard]] bool has(Index triangle, int edge) const { return (on_chain[triangle] >> edge & 1) != 0; }
};

/// The distance from the segment that a vertex of its chain may have.
enum class Strictness : std::uint8_t {
  exact,  ///< Domain::tolerance(), compared exactly
  /// A millionth of the segment's length, or any distance for a vertex whose origin is the segment. Used to tell a
  /// chain that leaves its segment from a chain that does not exist.
  loose,
};

/// Walks from one end of a segment to the other along mesh edges, always forward and never through another input
/// vertex. The edges run from the segment's end a to its end b. Empty where there is no such walk. With
/// Strictness::exact the origins of vertices do not decide which edges are allowed; they only choose between allowed
/// edges.
[[nodiscard]] std::vector<ChainEdge> walk_chain(Index segment, const Domain& domain, const Mesh& mesh,
                                                const Adjacency& adjacency, const InputVertices& inputs,
                                                Strictness strictness);

}  // namespace pardel::checker
