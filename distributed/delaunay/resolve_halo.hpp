// Ranks ask each other about the triangles at their borders, until all of them are Delaunay.
#pragma once

#include "../../core/ranks.hpp"
#include "../../parallel/threads/threads.hpp"
#include "curve_division.hpp"
#include "local_delaunay.hpp"

namespace pardel::engine {

/// Points that all ranks should know before they triangulate: enough that no rank has only collinear ones (unless all
/// points are collinear), and about 8 per rank from all over the plane, so that circles at the border of a rank do not
/// reach many other ranks. The result of the triangulation does not depend on their choice. Collective.
[[nodiscard]] std::vector<Site> common_sites(std::span<const Point> own, std::uint64_t first, std::uint64_t all,
                                             Ranks& ranks);

/// Adds points of other ranks to the triangulation, until each triangle with an own corner is one of the Delaunay
/// triangulation of the points of all ranks. Collective. Returns the number of rounds of questions.
///
/// In each round, a rank sends the new triangles that have an own corner to all ranks that may have points in their
/// disks. A rank that is asked adds the corners to its own triangulation, and answers with vertices in the disk, if
/// there are any. THEORY_OF_RANKS.md (GivenPoints) has the proof.
int resolve_halo(LocalDelaunay& delaunay, const CurveDivision& division, Ranks& ranks, const Threads& threads);

}  // namespace pardel::engine
