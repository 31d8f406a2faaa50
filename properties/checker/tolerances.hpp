// Tolerances: how far coordinates, distances and angles may differ before the checker reports a violation.
//
// Every other comparison of the checker is exact. See check.hpp for the list of exceptions.
#pragma once

namespace pardel {

/// The largest distance between a segment and a vertex on it, in units in the last place of the largest absolute
/// coordinate of the Pslg. (A unit in the last place of x is the distance from x to the next double.) A vertex that is
/// computed on a segment has rounded coordinates, each with an error of up to half a unit. The comparison is exact.
inline constexpr double chain_ulps = 2;

/// Two vertices lie on one shell (a circle around an apex) if their distances from the apex differ by at most
///     shell_tolerance * (the larger distance) + shell_ulps * (the unit of chain_ulps).
/// Vertices on segments are rounded, so the distances are rarely equal. They are computed in doubles.
inline constexpr double shell_tolerance = 1e-9;
inline constexpr double shell_ulps = 8;

/// A triangle exceeds Goal::size if its longest edge is longer than size(centroid) * (1 + size_tolerance). The centroid
/// and the length of the edge are computed in doubles.
inline constexpr double size_tolerance = 0x1p-40;

/// The double c that stands for the bound min_angle_deg: std::cos(min_angle_deg * pi / 180) for bounds from 0 to 90
/// degrees, cos 90 degrees for larger ones, and 1 (no bound) for a bound that is not positive. An angle between rays u
/// and v is too small if its exact cosine exceeds c: if u . v > 0 and (u . v)^2 > c^2 |u|^2 |v|^2. These numbers are
/// compared as rational numbers.
[[nodiscard]] double angle_cosine_bound(double min_angle_deg);

}  // namespace pardel
