// Domain: the part of the plane that has to be meshed, as the program Triangle defines it. A face of the Pslg belongs
// to the domain unless it is the exterior or contains the seed of a hole. If the convex hull is the outline, the hull
// edges that are not input segments ("hull pieces") are first appended to the segments.
#pragma once

#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "../../../core/pslg.hpp"
#include "../arithmetic/units.hpp"
#include "../tolerances.hpp"
#include "planar_faces.hpp"
#include "straight_paths.hpp"

namespace pardel::checker {

class Domain {
 public:
  /// Preconditions: segment ids are in range, coordinates are finite, `pslg` and `stop` outlive this object. O(n log n)
  /// time on typical input.
  Domain(const Pslg& pslg, bool convex_hull, StopSignal* stop = nullptr);
  Domain(const Domain&) = delete;
  Domain& operator=(const Domain&) = delete;

  /// The input segments, then the hull pieces.
  [[nodiscard]] std::span<const Segment> segments() const { return segments_; }
  [[nodiscard]] bool is_hull_piece(Index segment) const { return segment >= pslg_.segments.size(); }

  /// True if the face belongs to the domain.
  [[nodiscard]] bool inside(Index face) const { return face != no_index && inside_[face] != 0; }
  /// True if the face on this side of the segment belongs to the domain.
  [[nodiscard]] bool inside(Index segment, Side side) const { return inside(faces_.face(segment, side)); }
  /// True if the domain lies on at least one side of the segment. Other segments are not part of the mesh.
  [[nodiscard]] bool has(Index segment) const { return inside(segment, Side::left) || inside(segment, Side::right); }
  [[nodiscard]] bool on_boundary(Index segment) const {
    return inside(segment, Side::left) != inside(segment, Side::right);
  }
  /// True if the closed domain contains this input point.
  [[nodiscard]] bool has_point(Index point) const;

  [[nodiscard]] const PlanarFaces& faces() const { return faces_; }
  /// The straight paths of the segments that are part of the mesh. Computed when first called. Thread-safe.
  [[nodiscard]] const StraightPaths& straight_paths() const;
  /// The regions whose seeds lie in this face, as pairs (face, region). There is more than one only in an invalid Pslg.
  [[nodiscard]] std::span<const std::pair<Index, Index>> regions_in(Index face) const;

  /// Per face of faces(): a face of the graph of those segments that have the domain on a side, by the least number of
  /// the faces that it consists of. The mesh has no other segments, so it cannot tell apart what they separate.
  [[nodiscard]] std::vector<Index> places_of_faces() const;

  /// How far a vertex may lie off a segment, per axis (chain_units).
  [[nodiscard]] Units tolerance(Index segment) const {
    const Units units = units_of_segment(pslg_.points[segments_[segment].a], pslg_.points[segments_[segment].b]);
    return {chain_units * units.x, chain_units * units.y};
  }

 private:
  const Pslg& pslg_;
  std::vector<Segment> segments_;
  PlanarFaces faces_;
  std::vector<char> inside_;                        ///< per face
  std::vector<std::pair<Index, Index>> region_of_;  ///< (face, region), sorted
  StopSignal* stop_;
  mutable std::once_flag straight_paths_wanted_;
  mutable std::optional<StraightPaths> straight_paths_;
};

}  // namespace pardel::checker
