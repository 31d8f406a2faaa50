// The independent checker: is this mesh a right answer for this Pslg and Goal? Sees plain values only and
// decides every predicate exactly (CGAL's exact-predicates kernel; rational arithmetic where a comparison
// needs more). It includes nothing of the mesher.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "../../core/digest.hpp"
#include "../../core/goal.hpp"
#include "../../core/mesh.hpp"
#include "../../core/pslg.hpp"

namespace pardel {

enum class ViolationKind : std::uint8_t {
  index_out_of_range,  ///< a triangle, edge or region names something that does not exist
  non_finite_coordinate,
  wrong_count,          ///< an array of the mesh whose length does not fit
  degenerate_triangle,  ///< not strictly positively oriented
  duplicate_triangle,
  non_manifold_edge,    ///< more than two triangles, or two on the same side
  non_manifold_vertex,  ///< the triangles at a vertex make more fans than its boundary explains
  wrong_neighbour,      ///< n[] is not the triangle across the edge, or not reciprocal
  euler_characteristic,
  overlap,           ///< triangles cover some point twice
  uncovered_domain,  ///< part of the domain has no triangle
  covered_exterior,  ///< a triangle lies outside the domain or in a hole
  area_mismatch,
  missing_input_vertex,      ///< an input point of the domain is no vertex, or was moved or renumbered
  unused_vertex,             ///< a vertex without a triangle that is no input point outside the domain
  broken_segment,            ///< an input segment is no chain of mesh edges between its ends
  chain_off_segment,         ///< a chain vertex lies further from its segment than rounding explains
  wrong_constrained_edge,    ///< listed as constrained but no mesh edge, or not part of the segment it names
  missing_constrained_edge,  ///< part of a segment or hull but not listed
  wrong_edge_marker,
  wrong_vertex_marker,
  wrong_region,
  wrong_origin,
  not_delaunay,  ///< an unconstrained edge (any edge, for a conforming goal) not locally Delaunay
  small_angle,   ///< below the bound, and no small input angle justifies it
  large_area,
  region_area,
  long_edge,
  size_exceeded,
  large_circumradius,
  wrong_attribute,  ///< an input vertex does not carry its input attributes
};
[[nodiscard]] const char* name(ViolationKind kind);

/// How far a vertex on a segment may lie from it, in units in the last place (the spacing of doubles) of
/// the largest absolute coordinate of the Pslg. A point computed on a segment has to be rounded, half a unit
/// in each coordinate.
inline constexpr double chain_ulps = 2;

/// The double c that min_angle_deg is judged by: std::cos(min_angle_deg * pi / 180), 1 (no bound) for an angle
/// that is not positive, at least cos 90 degrees. A corner between rays u and v passes unless its exact cosine
/// exceeds c, that is unless u . v > 0 and (u . v)^2 > c^2 |u|^2 |v|^2, compared as rational numbers.
[[nodiscard]] double angle_cosine_bound(double min_angle_deg);

/// What is wrong, where, and an exact witness in words ("in-circle determinant +3/8192", "area 0.31 > 0.25").
struct Violation {
  ViolationKind kind;
  std::vector<Index> ids;  ///< vertices, triangles or segments; the message says which
  std::vector<Point> where;
  std::string witness;
  [[nodiscard]] std::string message() const;
};

struct CheckOptions {
  std::size_t max_violations = 1'000;  ///< listed per kind; all are counted
  double max_circumradius = 0;         ///< if positive: circumradius bound, compared exactly
  /// A mesh read from a file of another program carries no origin, and perhaps no markers, neighbours or
  /// constrained edges; what is absent (an empty array) is not judged, and input vertices are then
  /// matched by coordinates rather than by index.
  bool foreign = false;
};

struct Extreme {
  double value = 0;
  Index triangle = no_index;
  Point where;
};

/// An exempt triangle that the checker found justified itself: below the angle bound, but beside a small
/// input angle (nestled or seditious, THEORY).
struct Justified {
  Index triangle = no_index;
  Index apex = no_index;  ///< input vertex
  double input_angle_deg = 0;
  double angle_deg = 0;
};

struct Certificate {
  Goal goal;
  bool valid = false;
  std::vector<Violation> violations;
  std::vector<std::uint64_t> violation_counts;  ///< by kind
  std::vector<Justified> justified;
  std::uint64_t vertices = 0, triangles = 0, constrained_edges = 0;
  Extreme min_angle_deg, max_angle_deg, max_area, max_edge, min_edge, max_circumradius, max_radius_edge_ratio;
  double area = 0;
  std::vector<std::uint64_t> angle_histogram;  ///< 18 bins of 10 degrees over all angles
  Digest digest;
};

/// O(n log n); exact arithmetic only where filters do not decide. Memory besides the mesh: 8 bytes per triangle of a
/// right mesh without regions; where the neighbours have to be found again, 72.
[[nodiscard]] Certificate check(const Pslg& pslg, const Mesh& mesh, const Goal& goal, const CheckOptions& options = {});

/// The certificate as text for people, and as JSON, schema pardel.certificate/1.
[[nodiscard]] std::string to_text(const Certificate& certificate);
[[nodiscard]] std::string to_json(const Certificate& certificate);

}  // namespace pardel
