// Tolerances: how far coordinates, distances and angles may differ before the checker reports a violation.
//
// Every other comparison of the checker is exact. See check.hpp for the list of exceptions.
#pragma once

namespace pardel {

/// The largest distance between a segment and a vertex on it, in units in the last place of the largest absolute
/// coordinate of the Pslg. (A unit in the last place is the spacing of doubles there.) The coordinates of a vertex that
/// is computed on a segment have to be rounded, each by up to half a unit. Distances are compared exactly.
inline constexpr double chain_ulps = 2;

/// Two vertices lie on one shell around an apex where their distances from it differ by at most
///     shell_tolerance * (the larger distance) + shell_ulps * (the unit in the last place as in chain_ulps).
/// Vertices on segments are rounded, so equal distances cannot be demanded. These distances are computed in doubles.
inline constexpr double shell_tolerance = 1e-9;
inline constexpr double shell_ulps = 8;

/// Goal::size is exceeded where the longest edge is longer than size(centroid) * (1 + size_tolerance). The centroid and
/// the edge length are computed in doubles.
inline constexpr double size_tolerance = 0x1p-40;

/// The double c that stands for the bound min_angle_deg: std::cos(min_angle_deg * pi / 180) for bounds from 0 to 90
/// degrees, cos 90 degrees for larger ones, and 1 (no bound) for a bound that is not positive. An angle between rays u
/// and v is too small where its exact cosine exceeds c: where u . v > 0 and (u . v)^2 > c^2 |u|^2 |v|^2, compared as
/// rational numbers.
[[nodiscard]] double angle_cosine_bound(double min_angle_deg);

}  // namespace pardel
