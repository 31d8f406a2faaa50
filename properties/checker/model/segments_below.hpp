// SegmentsBelow: finds the segment of a planar straight-line graph that lies directly below a point.
#pragma once

#include <span>

#include "../../../core/pslg.hpp"
#include "box_tree.hpp"

namespace pardel::checker {

class SegmentsBelow {
 public:
  /// Both spans must outlive this object. O(n log n).
  SegmentsBelow(std::span<const Point> points, std::span<const Segment> segments, StopSignal* stop = nullptr);

  /// The first segment that a vertical ray downwards from p meets, or no_index. The ray starts just left of p, so end
  /// points and vertical segments are not special cases. Only segments strictly below p count.
  /// Precondition: segments do not cross. Exact; O(log n) time on typical input.
  [[nodiscard]] Index directly_below(Point p) const;

  /// A segment that contains p, or no_index. O(log n) time on typical input.
  [[nodiscard]] Index through(Point p) const;

 private:
  struct Ends {
    Point left, right;  ///< left has the smaller x-coordinate
  };
  [[nodiscard]] Ends ends(Index segment) const;
  [[nodiscard]] bool is_above(Index s, Index t) const;

  std::span<const Point> points_;
  std::span<const Segment> segments_;
  BoxTree tree_;
};

}  // namespace pardel::checker
