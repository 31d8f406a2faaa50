// The dividing path of Blelloch, Hardwick, Miller and Talmor: edges of the Delaunay triangulation that divide points
// near a line.
//
// Source: G. E. Blelloch, J. C. Hardwick, G. L. Miller, D. Talmor, "Design and implementation of a practical parallel
// Delaunay algorithm", Algorithmica 24 (1999), Section 2 (the projection and the lower hull).
#pragma once

#include <cstdint>
#include <vector>

#include "../mesh/linked_mesh.hpp"

namespace pardel::schemes {

/// The line that divides: x = constant, or y = constant.
enum class Cut : std::uint8_t { x, y };

/// p in coordinates in which the line is vertical: p itself, or p turned clockwise by a right angle. So "below the
/// median" is always on the left, and a path that goes up has this side on its left.
[[nodiscard]] inline Point turned(Point p, Cut cut) { return cut == Cut::x ? p : Point{p.y, -p.x}; }

/// The lower convex hull of the points (p.y - m.y, |p - m|^2), in turned coordinates, from the lowest y to the highest:
/// the projections of points of the paraboloid above m onto the plane through the line of the cut. Any two neighbours
/// on it lie on an empty circle with its centre on the line, so they are joined in the Delaunay triangulation of the
/// points. The tie rule of all cocircular points: the lexicographically smallest of them counts as nearest to the
/// centre. Then the Delaunay triangulation is unique: every polygon of cocircular points is a fan around its smallest
/// corner. Exact: the sign of a polynomial of degree 3 in differences of coordinates, by intervals, then by rational
/// numbers. O(n log n) time.
[[nodiscard]] std::vector<Index> dividing_path(const std::vector<Point>& points, const std::vector<Index>& of, Point m,
                                               Cut cut);

/// Flips sides whose four corners are cocircular until the tie rule of dividing_path() holds everywhere. Returns the
/// number of flips. Precondition: unconstrained sides are locally Delaunay.
std::uint64_t settle_ties(LinkedMesh& mesh);

}  // namespace pardel::schemes
