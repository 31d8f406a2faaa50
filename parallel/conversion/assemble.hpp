// Between plain values and the engine: a Pslg becomes a constrained Delaunay triangulation, a
// Triangulation becomes a Mesh.
#pragma once

#include <span>
#include <vector>

#include "../../core/mesh.hpp"
#include "../../core/pslg.hpp"
#include "../../core/result.hpp"
#include "../triangulation/constraint_lines.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// A domain ready for refinement, with the way back to the numbers of its input.
struct Assembled {
  Triangulation triangulation;
  Lines lines;
  Array<Index> input_of_vertex;        ///< for the vertices that were input points; the others keep their number
  std::vector<Index> segment_of_line;  ///< no_index for hull edges
  std::vector<int> marker_of_line;
};

/// The same on any number of threads. Precondition: the Pslg is valid (validate.hpp); what it would have found can give
/// invalid_input here.
[[nodiscard]] Result<Assembled> assemble(const Pslg& pslg, bool convex_hull, int threads = 1);

/// From an existing mesh: its constrained edges and its boundary become the lines, joined where the mesh knows the
/// provenance of its vertices (join_pieces.hpp). It is made constrained Delaunay by flips. A mesh that is no
/// manifold or not positively oriented gives invalid_input.
[[nodiscard]] Result<Assembled> assemble(const Mesh& mesh);

/// What the result inherits from the input's points; attributes of new points are interpolated.
struct PointData {
  std::size_t attributes_per_point = 0;
  std::span<const double> attributes;
  std::span<const int> markers;
};

/// Takes the triangulation apart without a second copy of it. Vertices keep the input's order and numbers,
/// then come the new ones in the order of their insertion. `background`: the corners, in input numbers, of the
/// triangles that attributes are interpolated on; may be empty when there are no attributes.
[[nodiscard]] Mesh disassemble(Assembled&& domain, std::vector<double> region_attributes, const PointData& data,
                               std::vector<std::array<Index, 3>> background, int threads = 1);

/// The corners of the triangles in input numbers.
[[nodiscard]] std::vector<std::array<Index, 3>> corners(const Assembled& domain);

}  // namespace pardel::engine
