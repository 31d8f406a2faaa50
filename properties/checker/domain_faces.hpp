// The faces of a domain: the connected parts of the plane that remain without the segments, except the exterior and the
// holes. Use it to hand a domain to a mesher that needs one surface per face, as Gmsh does.
#pragma once

#include <vector>

#include "../../core/pslg.hpp"

namespace pardel::checker {

/// Faces are numbered from 1, with gaps. The face outside the domain is no_index.
struct DomainFaces {
  struct Sides {
    Index left = no_index;   ///< the face on the left of the segment, looking from its end a to its end b
    Index right = no_index;  ///< the face on the right
  };
  struct IsolatedPoint {
    Index point = 0;
    Index face = 0;  ///< the face of the domain that contains the point
  };
  std::vector<Segment> segments;  ///< the input segments, then the edges of the convex hull that are not input segments
  std::vector<Sides> sides;       ///< per segment
  std::vector<IsolatedPoint> isolated_points;  ///< input points in the domain that no segment touches, in input order
};

/// Computes the faces. If `convex_hull` is true, the edges of the convex hull are segments too. Preconditions: segment
/// ids are in range and coordinates are finite. The result has no meaning if segments cross or overlap. O(n log n) time
/// on typical input.
[[nodiscard]] DomainFaces faces_of_domain(const Pslg& pslg, bool convex_hull);

}  // namespace pardel::checker
