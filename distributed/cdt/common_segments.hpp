// Which segments all ranks have to know.
#pragma once

#include <vector>

#include "../../core/ranks.hpp"
#include "../../parallel/threads/threads.hpp"
#include "../delaunay/local_delaunay.hpp"
#include "../delaunay/own_points.hpp"
#include "../delaunay/shared_hull.hpp"
#include "given_segment.hpp"

namespace pardel::engine {

/// If points are dense on segments, most segments are edges of the Delaunay triangulation of the points. Such a segment
/// is inserted by marking an edge. Only the ranks that have triangles at this edge need to know. The others are common:
/// - the segments that are no edges: they cross triangles;
/// - the segments that are sides of triangles that those cross;
/// - the segments that are edges of the convex hull.
struct DividedSegments {
  std::vector<GivenSegment> common;  ///< the same on all ranks, in the order of their ends
  std::vector<GivenSegment> own;     ///< others that end at points of this rank, in the order of their ends
  bool pass_points = false;          ///< true, on all ranks, if a point lies inside a segment
};

/// Collective. Afterwards the triangulation of each rank has all triangles that common segments cross, or have as a
/// side, in the triangulation of all points. Those that they cross are the only ones that change when the segments
/// become edges, so each rank can insert the common segments for itself, and gets all triangles with an own corner
/// right (THEORY_OF_RANKS.md, GivenPoints). `own_segments`: those that end at own points, in the order of their ends.
/// Precondition: all triangles with an own corner are those of the triangulation of all points.
[[nodiscard]] DividedSegments divide_segments(std::vector<GivenSegment>&& own_segments, const SharedHull& hull,
                                              LocalDelaunay& delaunay, const OwnPoints& own, Ranks& ranks,
                                              const Threads& threads);

}  // namespace pardel::engine
