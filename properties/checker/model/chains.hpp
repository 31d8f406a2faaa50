// Chains: a chain is the sequence of mesh edges into which a segment of the domain is divided.
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
  std::vector<ChainEdge> edges;  ///< sorted by segment, and in order along each segment
  Array<Index> segment_of;       ///< per vertex: the segment whose interior contains it, or no_index
  Array<std::uint8_t> on_chain;  ///< per triangle: bit i is set if edge i belongs to a chain
  std::vector<Index> broken;     ///< segments of the domain without a chain

  [[nodiscard]] bool has(Index triangle, int edge) const { return (on_chain[triangle] >> edge & 1) != 0; }
};

/// How far a vertex of a chain may lie from the segment.
enum class Strictness : std::uint8_t {
  exact,  ///< up to Domain::tolerance(), compared exactly
  /// Up to a millionth of the segment's length; any distance if the segment is the vertex's origin. Used to distinguish
  /// a chain that leaves its segment from a chain that does not exist.
  loose,
};

/// Walks along mesh edges from end a of a segment to end b, always forward and never through another input vertex.
/// Returns the edges of the walk, each in the direction from a to b; empty if there is no such walk. With
/// Strictness::exact the origins of vertices have no influence on which edges are allowed; they only select one of
/// several allowed edges.
[[nodiscard]] std::vector<ChainEdge> walk_chain(Index segment, const Domain& domain, const Mesh& mesh,
                                                const Adjacency& adjacency, const InputVertices& inputs,
                                                Strictness strictness);

}  // namespace pardel::checker
