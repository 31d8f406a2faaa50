// Domain: what a Pslg says is to be meshed, by Triangle's definition. A face of the Pslg belongs to the
// domain unless it is the exterior or holds a hole seed; where the convex hull is the outline, its edges
// that are no segments ("hull pieces") join the segments first.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "../../../core/pslg.hpp"
#include "planar_faces.hpp"

namespace pardel::checker {

class Domain {
 public:
  /// O(n log n) on typical input. Segment ids must be in range, coordinates finite; pslg must outlive this.
  Domain(const Pslg& pslg, bool convex_hull);
  Domain(const Domain&) = delete;
  Domain& operator=(const Domain&) = delete;

  /// The input segments, then the hull pieces.
  [[nodiscard]] std::span<const Segment> segments() const { return segments_; }
  [[nodiscard]] bool is_hull_piece(Index segment) const { return segment >= pslg_.segments.size(); }

  [[nodiscard]] bool inside(Index face) const { return face != no_index && inside_[face] != 0; }
  /// The face on one side of a segment belongs to the domain.
  [[nodiscard]] bool inside(Index segment, Side side) const { return inside(faces_.face(segment, side)); }
  /// A segment with the domain on neither side is rightly absent from the mesh.
  [[nodiscard]] bool has(Index segment) const { return inside(segment, Side::left) || inside(segment, Side::right); }
  [[nodiscard]] bool on_boundary(Index segment) const {
    return inside(segment, Side::left) != inside(segment, Side::right);
  }
  /// The closed domain contains this input point.
  [[nodiscard]] bool has_point(Index point) const;

  [[nodiscard]] const PlanarFaces& faces() const { return faces_; }
  /// The regions whose seeds lie in this face (more than one only in an invalid Pslg).
  [[nodiscard]] std::span<const std::pair<Index, Index>> regions_in(Index face) const;

  /// How far a vertex on a segment may lie from it: chain_ulps units in the last place of the largest
  /// coordinate of the Pslg.
  [[nodiscard]] double tolerance() const { return tolerance_; }
  /// One such unit.
  [[nodiscard]] double ulp() const { return ulp_; }

 private:
  const Pslg& pslg_;
  std::vector<Segment> segments_;
  PlanarFaces faces_;
  std::vector<char> inside_;                        ///< per face
  std::vector<std::pair<Index, Index>> region_of_;  ///< (face, region), sorted
  double ulp_ = 0;
  double tolerance_ = 0;
};

}  // namespace pardel::checker
