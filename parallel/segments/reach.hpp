// How near to each other points and segments may come before a repair brings them together.
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "../../core/pslg.hpp"
#include "snapping.hpp"

namespace pardel::engine {

/// Each point and each segment has a scale, a length that says how precise its place is. The scale of a segment is the
/// largest magnitude of a coordinate of its ends. That of a point is the smallest scale of its segments. A point
/// without segments has the smallest scale of all segments that is not smaller than its own largest coordinate; if
/// there is none, this coordinate. Of two things that may come together the smaller scale counts. So a large part of a
/// domain never moves a small part beside it.
class Reach {
 public:
  /// Indices must be in range. O(n log n).
  Reach(Snapping snapping, std::span<const Point> points, std::span<const Segment> segments);

  /// A point at which two segments will be split, after all points so far.
  void add_crossing(Index s, Index t) {
    of_point_.push_back(std::min(scale_of_segment(s), scale_of_segment(t)));
    own_.push_back(std::numeric_limits<double>::infinity());
  }

  [[nodiscard]] bool is_zero() const { return snapping_.is_zero(); }
  [[nodiscard]] double scale_of_point(Index p) const { return of_point_[p]; }
  [[nodiscard]] double scale_of_segment(Index s) const { return of_segment_[s]; }
  /// The scale of a point without segments.
  [[nodiscard]] double scale_of_place(Point p) const;
  /// The scale of two points: if neither of them has segments, the larger one of their own coordinates.
  [[nodiscard]] double scale_of_points(Index p, Index q) const {
    return std::min({of_point_[p], of_point_[q], std::max(own_[p], own_[q])});
  }

  /// Things with these scales come together if they are closer than this.
  [[nodiscard]] double between(double scale, double other) const { return snapping_.at(std::min(scale, other)); }
  [[nodiscard]] double between_points(Index p, Index q) const { return snapping_.at(scale_of_points(p, q)); }
  /// No other thing comes together with one of this scale from farther away.
  [[nodiscard]] double farthest(double scale) const { return snapping_.largest_up_to(scale); }
  /// The largest distance of all.
  [[nodiscard]] double largest() const;

 private:
  Snapping snapping_;
  std::vector<double> of_point_, of_segment_;
  std::vector<double> own_;     ///< of points without segments; infinity for others
  std::vector<double> sorted_;  ///< the scales of segments
};

}  // namespace pardel::engine
