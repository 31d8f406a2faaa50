// SegmentsBelow: which segment of a plane straight-line graph lies directly below a point.
#pragma once

#include <span>

#include "../../../core/pslg.hpp"
#include "box_tree.hpp"

namespace pardel::checker {

/// Segments of a plane straight-line graph, to be asked what lies below a point.
class SegmentsBelow {
 public:
  /// Both spans must outlive this.
  SegmentsBelow(std::span<const Point> points, std::span<const Segment> segments);

  /// The segment that a ray straight down from p hits first, no_index when none: of those whose interior
  /// lies strictly below p at an abscissa just left of p's (so that ends and vertical segments need no
  /// cases of their own). Segments must not cross. Exact; O(log n) on typical input.
  [[nodiscard]] Index directly_below(Point p) const;

  /// Some segment that contains p, no_index when none.
  [[nodiscard]] Index through(Point p) const;

 private:
  struct Ends {
    Point left, right;  ///< left has the smaller abscissa
  };
  [[nodiscard]] Ends ends(Index segment) const;
  [[nodiscard]] bool is_above(Index s, Index t) const;

  std::span<const Point> points_;
  std::span<const Segment> segments_;
  BoxTree tree_;
};

}  // namespace pardel::checker
