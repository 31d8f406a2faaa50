// Tolerances: how far coordinates, distances and angles may differ before the checker reports a violation. There are no
// others. Each is compared exactly, so the smallest value above it is reported (see check.hpp).
#pragma once

namespace pardel {

/// The largest distance between a segment and a vertex on it, in units in the last place of the largest absolute
/// coordinate of the Pslg. (A unit in the last place of x is the distance from x to the next double.) A vertex that is
/// computed on a segment has rounded coordinates. Each is off by at most half a unit if it is rounded once, which moves
/// the vertex by at most 0.71 units. The rest is for meshers that round more than once.
inline constexpr double chain_ulps = 2;

/// The least unit: a Pslg has no coordinate between 0 and this value, and a mesher may round computed ones to 0 there.
/// So it is the distance of coordinates near 0. It counts if all coordinates are below 2^-87.
inline constexpr double least_unit = 0x1p-140;

/// If a segment has no chain within chain_ulps, the checker looks for the chain that was meant, to report its vertices
/// as chain_off_segment. They may be off by this share of the segment's length, or further along edges that the mesh
/// lists as constrained. If there is no such chain, it reports broken_segment. So this value decides between two
/// violations, never whether a mesh is valid, and the distance is computed in doubles.
inline constexpr double meant_chain_share = 1e-6;

/// Two vertices lie on one shell (a circle around an apex) if their distances from the apex differ by at most
///     shell_tolerance * (the larger distance) + shell_ulps * (the unit of chain_ulps).
/// Vertices on segments are rounded, so the distances are rarely equal. The first term is for meshers that compute
/// distances with errors that grow with the distance. Both are small compared with the distance of two shells: the
/// radius of a shell is at least 1.5 times that of the next smaller shell.
inline constexpr double shell_tolerance = 1e-9;
inline constexpr double shell_ulps = 8;

/// Shells justify small angles only between two segments that meet at less than 60 degrees, that is, if the cosine of
/// their angle is greater than this value. At 60 degrees and more refinement needs no exceptions.
inline constexpr double shell_cosine = 0.5;

/// The length that Goal::grading and Goal::feature_edges allow at a centroid is computed in doubles. An edge is too
/// long if it exceeds (1 + size_tolerance) * (that length) + size_ulps * (the unit of chain_ulps).
inline constexpr double size_tolerance = 1e-9;
inline constexpr double size_ulps = 64;

/// The double c that stands for the bound min_angle_deg: std::cos(min_angle_deg * pi / 180) for bounds from 0 to 90
/// degrees, cos 90 degrees for larger ones, and 1 (no bound) for a bound that is not positive. An angle between rays u
/// and v is too small if its exact cosine exceeds c: if u . v > 0 and (u . v)^2 > c^2 |u|^2 |v|^2. These numbers are
/// compared as rational numbers.
[[nodiscard]] double angle_cosine_bound(double min_angle_deg);

}  // namespace pardel
