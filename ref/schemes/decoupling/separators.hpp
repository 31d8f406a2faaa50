// Separators: lines that divide a domain into parts, laid into its mesh as edges before the parts are refined.
//
// Source: L. Linardakis, N. Chrisochoides, "Delaunay decoupling method for parallel guaranteed quality planar mesh
// refinement", 2006: separators are divided so finely that no refinement of a part splits them.
#pragma once

#include <functional>

#include "../workers/territory.hpp"

namespace pardel::schemes::decoupled {

/// The division of the plane into parts, numbered from 0, by upright and level lines.
struct Plan {
  std::vector<Territory::Line> lines;
  int parts = 1;
  std::function<int(Point)> part_of;
};
/// A lattice of about as many parts as workers, over the extent of the mesh.
[[nodiscard]] Plan lattice_plan(const LinkedMesh& mesh, int workers);
/// The borders of the territory: a part for each worker.
[[nodiscard]] Plan bisection_plan(const LinkedMesh& mesh, const Territory& territory);

/// Separators in a mesh: segments that are not in the input.
struct Laid {
  Index first = 0;         ///< segments from this one on are separators
  std::size_t pieces = 0;  ///< of separators
  /// Pieces that are not there: they would be no Delaunay edges, or meet a segment at a bad angle.
  std::size_t gaps = 0;
  std::uint64_t work = 0;
};

/// Pieces have at most this length in roots of the wanted area. A triangle that is too large, or has an edge that is
/// too long, has a circumradius of more than this length divided by sqrt 2. No triangle with a larger circumradius has
/// a circumcentre that encroaches upon a piece: a point of the diametral circle is nearer than that to an end.
inline constexpr double piece_of_unit_area = 1.07;

/// Inserts the points of the separators into the mesh and makes the edges between them segments. Where a line crosses a
/// segment at 60 degrees or more, and the segment has no small angle, their crossing becomes a vertex; otherwise the
/// line has a gap there, as at a vertex of a segment. Points that encroach upon a segment, or are nearer than half a
/// piece to another vertex, are left out, and so are crossings that are almost vertices. `length`: of pieces, in units
/// of the longest ones that are known to be safe. Stops when the mesh has more than `most_points`.
[[nodiscard]] Laid lay(LinkedMesh& mesh, const Bounds& bounds, const Plan& plan, double length,
                       std::size_t most_points);

}  // namespace pardel::schemes::decoupled
