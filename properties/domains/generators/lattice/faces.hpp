// LatticeFaces: the faces into which segments divide the plane, computed in exact integers. It is independent of the
// checker's PlanarFaces, which works on doubles.
#pragma once

#include <span>
#include <vector>

#include "../lattice_domain.hpp"
#include "determinants.hpp"

namespace pardel::generators {

/// A side of a segment: from point `a` to point `b`, with a face on its left.
struct HalfEdge {
  Index a = 0;
  Index b = 0;
  friend bool operator==(const HalfEdge&, const HalfEdge&) = default;
};

/// Half-edge 2s runs along segment s from its end a to its end b, half-edge 2s + 1 from b to a. If there are no
/// segments, the sides of the convex hull are used as segments.
class LatticeFaces {
 public:
  static constexpr Index exterior = 0;

  /// The faces without holes. Preconditions: points are distinct and not all collinear; segments meet in common ends
  /// only and pass through no point. O(points * segments).
  LatticeFaces(const std::vector<LatticePoint>& points, const std::vector<Segment>& segments);
  /// The faces with the holes of the domain. Precondition: no seed of a hole lies on a segment.
  explicit LatticeFaces(const LatticeDomain& domain);

  [[nodiscard]] Index count() const { return count_; }
  [[nodiscard]] Index half_edges() const { return static_cast<Index>(ends_.size()); }
  [[nodiscard]] HalfEdge ends(Index half_edge) const { return ends_[half_edge]; }
  [[nodiscard]] static Index twin(Index half_edge) { return half_edge ^ 1U; }
  [[nodiscard]] Index left_of(Index half_edge) const { return face_of_[contour_of_[half_edge]]; }
  /// True if the half-edge is on the outer contour of its face, false if it is on a contour inside the face.
  [[nodiscard]] bool on_outer_contour(Index half_edge) const { return is_outer_[contour_of_[half_edge]]; }
  /// The half-edges that start at a point, counter-clockwise.
  [[nodiscard]] std::span<const Index> around(Index point) const {
    return std::span(by_origin_).subspan(first_[point], first_[point + 1] - first_[point]);
  }

  /// Seeds are in quarters of the lattice unit.
  [[nodiscard]] bool on_a_segment(LatticePoint seed) const;
  /// Precondition: !on_a_segment(seed).
  [[nodiscard]] Index containing(LatticePoint seed) const;
  /// A seed of the bounded face on the left of a half-edge. The seed lies in a triangle that has the half-edge as a
  /// side and that no segment crosses.
  [[nodiscard]] LatticePoint seed_left_of(Index half_edge) const;

  void make_hole(Index face) { is_domain_[face] = false; }
  [[nodiscard]] bool is_domain(Index face) const { return is_domain_[face]; }
  [[nodiscard]] Index domain_faces() const;

 private:
  void link();
  void trace_contours();
  /// The half-edge from left to right directly below a place, just right of it, or no_index.
  [[nodiscard]] Index directly_below(LatticePoint place) const;
  [[nodiscard]] bool is_above(Index half_edge, Index other) const;
  [[nodiscard]] LatticePoint at(Index point) const { return quarters_[point]; }

  std::vector<LatticePoint> quarters_;  ///< the points, in quarters
  std::vector<HalfEdge> ends_;
  std::vector<Index> by_origin_;   ///< half-edges by their first point, then by angle
  std::vector<Index> first_;       ///< per point: its first position in by_origin_; one more entry at the end
  std::vector<Index> contour_of_;  ///< per half-edge
  std::vector<char> is_outer_;     ///< per contour
  std::vector<Index> face_of_;     ///< per contour
  std::vector<char> is_domain_;    ///< per face
  Index count_ = 1;
};

}  // namespace pardel::generators
