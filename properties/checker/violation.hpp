// Violations: the rules that a mesh can break, and the report of one broken rule.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "../../core/pslg.hpp"
#include "witness.hpp"

namespace pardel {

/// There is one kind of violation for each rule. The lists in a certificate have the order of this enumeration.
enum class ViolationKind : std::uint8_t {
  index_out_of_range,  ///< a triangle, edge or region refers to something that does not exist
  non_finite_coordinate,
  wrong_count,          ///< the length of an array of the mesh does not fit the other arrays
  degenerate_triangle,  ///< a triangle is not strictly counter-clockwise
  duplicate_triangle,   ///< two triangles have the same corners
  non_manifold_edge,    ///< an edge has more than two triangles, or two on the same side
  non_manifold_vertex,  ///< the triangles at a vertex form more fans than its boundary edges explain
  wrong_neighbour,      ///< n[] is not the triangle across the edge, or that triangle does not refer back
  euler_characteristic,
  overlap,                   ///< triangles cover some point twice
  uncovered_domain,          ///< a part of the domain has no triangle
  covered_exterior,          ///< a triangle lies outside the domain or in a hole
  area_mismatch,             ///< the areas of the triangles do not sum to the area within the boundary chains
  missing_input_vertex,      ///< an input point of the domain is not a vertex, or was moved or renumbered
  unused_vertex,             ///< a vertex has no triangle and is not an input point outside the domain
  broken_segment,            ///< no chain of mesh edges joins the ends of an input segment
  chain_off_segment,         ///< a vertex of a chain lies further than chain_units from its segment
  chains_meet,               ///< the chains of two segments share a vertex that is no input point
  wrong_chain_order,         ///< around an input point, the chains are not in the order of their segments
  wrong_face,                ///< chains separate or join other parts than the segments do, or a point changed sides
  wrong_constrained_edge,    ///< an edge is listed as constrained, but is no mesh edge or no part of its segment
  missing_constrained_edge,  ///< an edge is a part of a segment or of the hull, but is not listed as constrained
  wrong_edge_marker,
  wrong_vertex_marker,
  wrong_region,  ///< a triangle has not the region of its face, or one where its face has none
  wrong_origin,
  not_delaunay,    ///< an unconstrained edge is not locally Delaunay
  not_conforming,  ///< a constrained edge is not locally Delaunay, and the goal is conforming
  small_angle,     ///< an angle is below the bound, and no small input angle justifies it (see Justified)
  large_area,
  region_area,  ///< the area of a triangle exceeds the cap of its region
  long_edge,
  size_exceeded,  ///< an edge is longer than the sizing function allows at the triangle's centroid
  user_test,      ///< Goal::user_test says that the triangle must be refined
  large_circumradius,
  /// An input vertex does not carry its input attributes, or the value of an inserted vertex is not between those that
  /// it interpolates.
  wrong_attribute,
};

/// The number of kinds. The enumerators have the values 0 to violation_kinds - 1.
inline constexpr std::size_t violation_kinds = static_cast<std::size_t>(ViolationKind::wrong_attribute) + 1;

/// The name of a kind in certificates, for example "wrong_neighbour". "unknown" if the value is not an enumerator.
[[nodiscard]] const char* name(ViolationKind kind);

/// One broken rule, with its place and an exact witness.
struct Violation {
  ViolationKind kind;
  std::vector<Index> ids;    ///< of vertices, triangles, edges or segments, from 0; the witness says which
  std::vector<Point> where;  ///< places in the mesh or in the input
  Witness witness;           ///< the proof as text: "in-circle determinant +3/8192", "area 0.31 > 0.25"

  /// One line: the kind, the witness, the ids and the places. All numbers count from 0.
  [[nodiscard]] std::string message() const;
  /// The same without the ids, with the numbers of files.
  [[nodiscard]] std::string message(const NumbersInWitnesses& numbers) const;
};

}  // namespace pardel
