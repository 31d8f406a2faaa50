// Tolerances: how far coordinates, distances and angles may differ before the checker reports a violation. There are no
// others. Each is compared exactly, so the smallest value above it is reported (see check.hpp). All are local: nothing
// in the checker depends on the largest coordinate of the input. The unit of a number is its distance from the next
// larger double (arithmetic/units.hpp).
#pragma once

namespace pardel {

/// How far a vertex may lie off its segment, in units of the segment. Let ux be the unit of the larger |x| of the
/// segment's two ends, and uy that of the larger |y|. The distance from the segment's line is at most the largest that
/// an error of chain_units * ux in x and of chain_units * uy in y can cause: with (dx, dy) from one end to the other,
///     chain_units * (ux * |dy| + uy * |dx|) / sqrt(dx^2 + dy^2).
/// A vertex that is computed on a segment has rounded coordinates. Each is off by at most half a unit if it is rounded
/// once. The rest is for meshers that round more than once. The points of a straight path of segments
/// (model/straight_paths.hpp) may lie as far off the line through its ends.
inline constexpr double chain_units = 2;

/// If a segment has no chain within chain_units, the checker looks for the chain that was meant, to report its vertices
/// as chain_off_segment. They may be off by this share of the segment's length, or further along edges that the mesh
/// lists as constrained. If there is no such chain, it reports broken_segment. So this value decides between two
/// violations, never whether a mesh is valid, and the distance is computed in doubles.
inline constexpr double meant_chain_share = 1e-6;

/// Two vertices lie on one shell (a circle around an apex) if their distances from the apex differ by at most
///     shell_tolerance * (the larger distance) + shell_units * (the unit at the largest coordinate of the apex and
///     both).
/// Vertices on segments are rounded, so the distances are rarely equal. The first term is for meshers that compute
/// distances with errors that grow with the distance. Both are small compared with the distance of two shells: the
/// radius of a shell is at least 1.5 times that of the next smaller shell.
inline constexpr double shell_tolerance = 1e-9;
inline constexpr double shell_units = 8;

/// Shells justify small angles only between two segments that meet at less than 60 degrees, that is, if the cosine of
/// their angle is greater than this value. At 60 degrees and more refinement needs no exceptions.
inline constexpr double shell_cosine = 0.5;

/// The cosine of about one degree. Where two segments meet at a smaller angle, one of the two vertices on a shell may
/// be the end of its segment.
inline constexpr double narrow_cosine = 0.9998477;

/// An angle across a shell is justified if its tangent is at least sin θ / (2 - cos θ), where θ is the angle of the
/// segments (Miller, Pav, Walkington 2003), up to this relative error and to an error of across_units units in each
/// coordinate of the two vertices on the shell. The unit is that of the shell, however far the corner is.
inline constexpr double across_tolerance = 1e-8;
inline constexpr double across_units = 8;

/// The length that Goal::grading and Goal::feature_edges allow at a centroid is computed in doubles. An edge is too
/// long if it exceeds (1 + size_tolerance) * (that length) + size_units * (the unit at the largest coordinate of the
/// triangle).
inline constexpr double size_tolerance = 1e-9;
inline constexpr double size_units = 64;

/// An attribute of an inserted vertex is interpolated in doubles. It may leave the range of the values between which it
/// lies by this share of the largest magnitude in this range.
inline constexpr double attribute_tolerance = 1e-9;

/// The double c that stands for the bound min_angle_deg: std::cos(min_angle_deg * pi / 180) for bounds from 0 to 90
/// degrees, cos 90 degrees for larger ones, and 1 (no bound) for a bound that is not positive. An angle between rays u
/// and v is too small if its exact cosine exceeds c: if u . v > 0 and (u . v)^2 > c^2 |u|^2 |v|^2. These numbers are
/// compared as rational numbers.
[[nodiscard]] double angle_cosine_bound(double min_angle_deg);

}  // namespace pardel
