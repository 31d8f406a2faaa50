// Verifies the answer of a mesher against the contract (subdomain_mesher.hpp). Nothing of the answer is believed.
#pragma once

#include <span>
#include <vector>

#include "../../core/result.hpp"
#include "../../parallel/arithmetic/clearance.hpp"
#include "../../parallel/arithmetic/floor.hpp"
#include "../breach.hpp"
#include "../subdomain_mesher.hpp"

namespace pardel::engine {

/// An answer that keeps the contract, made constrained Delaunay, with what verification has found out. A side has the
/// number 3 * triangle + i.
struct VerifiedSubdomain {
  std::vector<Point> points;             ///< those on edges are moved onto the lines of the edges
  std::vector<Index> edge_of_new_point;  ///< as in RefinedSubdomain
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> across;   ///< per side: the same edge as a side of the other triangle; no_index on the border
  std::vector<Index> on_edge;  ///< per side: the edge of Subdomain::edges of which it is a piece; no_index: of none
};

/// Returns the answer if it is a triangulation of the subdomain that keeps the contract, otherwise the first breach:
/// - The points of the subdomain are there, and at most most_new_points others, in the cell and on their edges.
/// - All triangles are exactly counter-clockwise, no two lie on the same side of an edge, and the border is that of the
///   subdomain. Then they cover the subdomain once: the number of triangles over a place is the winding number of the
///   border, which has not changed.
/// - All edges that must stay are there, and the frozen ones whole.
/// - After flips to the constrained Delaunay triangulation, no new edge is shorter than the floor, and no new point is
///   nearer than 8 times the floor of double precision to another point or to an edge that must stay. So only a
///   bounded number of points can be inserted, and pardel's own refiner has room to complete the mesh.
/// `lines`: for each edge of the subdomain, the line on which its new points have to lie. O(n) for n triangles, if
/// vertices have few neighbours.
[[nodiscard]] Result<VerifiedSubdomain, Breach> verify(const Subdomain& subdomain, RefinedSubdomain&& answer,
                                                       std::span<const EndPoints> lines, const Floor& floor);

}  // namespace pardel::engine
