// Chains: a chain is the sequence of mesh edges into which a segment of the domain is divided.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "../../../core/mesh.hpp"
#include "adjacency.hpp"
#include "domain.hpp"
#include "input_vertices.hpp"
#include "marked_edges.hpp"

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

/// The parts of a mesh from which chains are found. Files of meshes contain all of them. So a mesh in memory and the
/// same mesh read from a file have the same chains. Mesh::origin is not among them, because no file contains it.
struct MeshEdges {
  std::span<const Point> points;
  const Adjacency& adjacency;
  MarkedEdges marked;
};

/// How far a vertex of a chain may lie from the segment.
enum class Strictness : std::uint8_t {
  exact,  ///< up to Domain::tolerance() of the segment, compared exactly
  /// Up to a millionth of the segment's length; any distance along marked edges. Used to distinguish a chain
  /// that leaves its segment from a chain that does not exist.
  loose,
};

/// Finds a path of mesh edges from end a of a segment to end b, always forward and never through another input vertex.
/// Returns its edges, each in the direction from a to b; empty if there is no such path. With Strictness::exact the
/// marked edges have no influence on which edges are allowed; they only select one of several allowed paths: between
/// segments that nearly coincide, edges of one segment are allowed for the other, too. Time: O(k log k) for k edges
/// within the tolerance, plus the triangles at their ends.
/// `others`: if given, the chain passes no vertex for which this is neither no_index nor the segment.
[[nodiscard]] std::vector<ChainEdge> find_chain(Index segment, const Domain& domain, const MeshEdges& mesh,
                                                const InputVertices& inputs, Strictness strictness,
                                                StopSignal* stop = nullptr, std::span<const Index> others = {});

}  // namespace pardel::checker
