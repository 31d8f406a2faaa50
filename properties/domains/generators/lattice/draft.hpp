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

  /// Returns the point at this place; adds it if necessary. A segment that passes through the place is split there.
  Index point(LatticePoint place);
  /// Adds a point. Does nothing and returns false if a point or segment is at this place.
  bool free_point(LatticePoint place);
  /// Adds a segment; points on the segment divide it into several segments. Does nothing and returns false if it would
  /// cross another segment or if a == b.
  bool segment(LatticePoint a, LatticePoint b);
  /// Adds the sides of an open path as segments.
  void path(std::span<const LatticePoint> contour);
  /// Adds the sides of a closed polygon as segments.
  void polygon(std::vector<LatticePoint> contour);
  /// Adds a polygon. Does nothing and returns false if its closed bounding box contains a point or meets a segment.
  bool free_polygon(const std::vector<LatticePoint>& contour);
  /// Adds the sides of the convex hull as segments, so that they form an outline.
  void hull();

  /// Makes a hole: the face on the left of the segment that starts at a in the direction of b. Does nothing if it is
  /// the last face of the domain.
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
