// Divide and conquer of given points: parts of the Delaunay triangulation are found before any triangle exists, so the
// workers never have to merge triangulations. At the median the points are projected onto a paraboloid and then onto
// the plane above the cut; the lower hull of this projection is a path of Delaunay edges. It divides the points, points
// on it go to both sides, and both sides are divided again, until each worker has one part. Then a sequential algorithm
// triangulates each part inside its border.
//
// Sources: G. E. Blelloch, J. C. Hardwick, G. L. Miller, D. Talmor, "Design and implementation of a practical parallel
// Delaunay algorithm", Algorithmica 24 (1999), Figure 4; H. Edelsbrunner, W. Shi, 1991 (the same idea for hulls).
//
// Where an implementer goes wrong: the path may touch the border and leave the region, so only its edges inside become
// border; edges between two points of the path need their own test of sides; cocircular points, for which the edges of
// two paths cross unless one tie rule holds for all paths and for the triangulation of parts (path.hpp).
//
// Work: a hull of n points counts n, the triangulation of a part as triangulation_of() counts it. Messages: hulls of
// shares, paths, and points that travel. Nothing is wasted or set back. A worker holds the triangles of its part, also
// those outside the border that it removes. Points of the input are no insertions.
//
// Left open: whether cuts alternate or follow the longer extent; how a team finds a hull (here: hulls of equal shares,
// joined by the team's first worker).
#pragma once

#include "given_points/part.hpp"
#include "workers/problem.hpp"

namespace pardel::schemes {

enum class CutOrder : std::uint8_t {
  alternating,   ///< x, y, x, ... (Section 3)
  longer_extent  ///< across the longer extent of the part's points
};

struct GivenPointsOptions {
  CutOrder cuts = CutOrder::alternating;
};

/// The direction of the cut of a part. `level`: number of cuts before it.
[[nodiscard]] Cut cut_of(const std::vector<Point>& points, const std::vector<Index>& of, int level, CutOrder order);

/// The points, divided among workers.
struct Division {
  std::vector<Part> parts;                ///< of each worker; a worker may have none
  std::vector<std::vector<Index>> paths;  ///< all paths, level by level
  std::vector<int> levels;                ///< of each worker: number of cuts of its part
};

/// Divides the points, and adds the cost to the account. A part without inner points is not divided (Figure 4, step 1).
/// Precondition: at least three points, not all on one line. O(n log n log workers) time.
[[nodiscard]] Division division_of(const std::vector<Point>& points, int workers, const GivenPointsOptions& options,
                                   Account& account);

/// The triangles of all parts, in the order of the workers.
struct Triangles {
  std::vector<Corners> corners;
  std::vector<int> owner;  ///< of each triangle
};
/// Triangulates all parts at the same time, and adds the cost to the account.
[[nodiscard]] Triangles triangles_of(const std::vector<Point>& points, const Division& division, Account& account);

/// The Delaunay triangulation of the points, whose hull is constrained. It depends on the points only. Errors: `usage`
/// if the problem has segments or bounds; those of triangulation_of().
[[nodiscard]] Result<Outcome> triangulate_given_points(const Problem& problem, const GivenPointsOptions& options = {});

}  // namespace pardel::schemes
