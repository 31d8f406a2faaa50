// A domain while it is drawn: what does not fit is left out at once, so that every draft is sound.
#pragma once

#include <span>
#include <vector>

#include "faces.hpp"
#include "lattice.hpp"
#include "lattice_domain.hpp"
#include "random.hpp"

namespace pardel::generators {

class Draft {
 public:
  [[nodiscard]] const std::vector<LatticePoint>& points() const { return points_; }

  /// The point there; a segment that ran through it has it as an end from now on.
  Index point(LatticePoint place);
  /// A new point, only where there is neither a point nor a segment.
  bool free_point(LatticePoint place);
  /// In pieces where it runs through points; left out, with false, where it would cross a segment.
  bool segment(LatticePoint a, LatticePoint b);
  /// Each of its sides as a segment. A contour that goes on from its end is not closed.
  void path(std::span<const LatticePoint> contour);
  void polygon(std::vector<LatticePoint> contour);
  /// A polygon, only where its bounding box, as far as it goes, is empty.
  bool free_polygon(const std::vector<LatticePoint>& contour);
  /// Segments around the convex hull, so that the domain has an outline.
  void hull();

  /// The face left of this direction from a to become a hole, unless nothing would be left of the domain.
  void hole_left_of(LatticePoint a, LatticePoint b) { holes_.push_back({a, b}); }

  /// With up to `regions` regions in faces of the domain, points and segments in random order.
  [[nodiscard]] LatticeDomain finished(Random& random, int regions) const;

 private:
  struct Direction {
    LatticePoint from, to;
  };
  [[nodiscard]] bool is_segment(Index a, Index b) const;

  std::vector<LatticePoint> points_;
  std::vector<Segment> segments_;
  std::vector<Direction> holes_;
};

}  // namespace pardel::generators
