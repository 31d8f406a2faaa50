// What refinement does where two segments meet at less than 60 degrees: concentric shells (Ruppert 1995), and the
// triangles that it leaves there (Miller, Pav and Walkington, "When and why Ruppert's algorithm works", 2003).
#pragma once

#include <vector>

#include "../mesh/linked_mesh.hpp"

namespace pardel::schemes {

class SmallAngles {
 public:
  /// `mesh`: the triangulation of the domain before its refinement. Linear time, but quadratic in the number of
  /// segments at one point.
  explicit SmallAngles(const LinkedMesh& mesh);

  /// The point at which a constrained side is split: its midpoint. If exactly one of its ends is the end of its segment
  /// and has a small angle there, the point whose distance from this end is a power of two and nearest to the half.
  [[nodiscard]] Point split_point(const LinkedMesh& mesh, Side side) const;
  /// The same for the part from a to b of segment s.
  [[nodiscard]] Point split_point(const LinkedMesh& mesh, Index s, Index a, Index b) const;

  /// Has the segment an end at which it meets another one at less than 60 degrees?
  [[nodiscard]] bool is_at(Index segment) const { return sharp_[segment][0] || sharp_[segment][1]; }

  /// Does a small angle of the domain justify the angle of t at corner k? It does if the angle is between two segments
  /// that meet there at less than 60 degrees, or if the opposite side joins two points of one shell around such a
  /// corner; and if it is not smaller than such a corner explains.
  [[nodiscard]] bool justify(const LinkedMesh& mesh, Index t, int k) const;

 private:
  /// The cosine of the angle between two segments at their common end.
  [[nodiscard]] static double cosine_between(const LinkedMesh& mesh, Index s, Index r, Index apex);

  Index inputs_;                            ///< number of input points
  std::vector<std::array<bool, 2>> sharp_;  ///< of each segment: is there a small angle at this end?
};

}  // namespace pardel::schemes
