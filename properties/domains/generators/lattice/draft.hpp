// Draft: a domain under construction. Points and segments that do not fit are left out, so a draft is always valid.
#pragma once

#include <span>
#include <vector>

#include "../lattice_domain.hpp"
#include "../random.hpp"
#include "determinants.hpp"
#include "faces.hpp"

namespace pardel::generators {

class Draft {
 public:
  [[nodiscard]] const std::vector<LatticePoint>& points() const { return points_; }

  /// The point at this place, added if necessary. A segment that passes through it is split there.
  Index point(LatticePoint place);
  /// Adds a point where there is neither a point nor a segment. False where there is one.
  bool free_point(LatticePoint place);
  /// Adds a segment, in pieces where it passes through points. False, and nothing is added, where it would cross
  /// another segment or where a == b.
  bool segment(LatticePoint a, LatticePoint b);
  /// Adds the sides of an open path as segments.
  void path(std::span<const LatticePoint> contour);
  /// Adds the sides of a closed polygon as segments.
  void polygon(std::vector<LatticePoint> contour);
  /// Adds a polygon where its closed bounding box contains no point and meets no segment. False where it does.
  bool free_polygon(const std::vector<LatticePoint>& contour);
  /// Adds segments around the convex hull as an outline.
  void hull();

  /// Makes a hole of the face on the left of the segment that leaves a towards b, unless it is the last face of the
  /// domain.
  void hole_left_of(LatticePoint a, LatticePoint b) { holes_.push_back({a, b}); }

  /// The domain, with points and segments in random order and up to `regions` regions in faces of the domain.
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
