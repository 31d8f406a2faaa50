// The faces into which segments cut the plane: which of them lies left and right of each segment, which
// contains a point. Exact.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "../../core/pslg.hpp"
#include "segment_index.hpp"

namespace pardel::engine {

/// Face 0 is the exterior, the one that is unbounded. A face may have islands: components of the segments' graph
/// that lie inside it. Keeps references to its arguments.
/// Preconditions: segments meet only at common ends (by index), coordinates are in the predicates' range, and
/// `index` is over the same segments. O(n log n) on typical input.
class Faces {
 public:
  static constexpr Index exterior = 0;

  Faces(std::span<const Point> points, std::span<const Segment> segments, const SegmentIndex& index);

  [[nodiscard]] Index count() const { return count_; }
  /// As seen from a to b.
  [[nodiscard]] Index left_of(Index segment) const { return face_[2 * std::size_t{segment}]; }
  [[nodiscard]] Index right_of(Index segment) const { return face_[2 * std::size_t{segment} + 1]; }
  /// Precondition: p is on no segment.
  [[nodiscard]] Index containing(Point p) const;

 private:
  [[nodiscard]] Index half_edge_above(Index segment) const;

  std::span<const Point> points_;
  std::span<const Segment> segments_;
  const SegmentIndex& index_;
  std::vector<Index> face_;  ///< left of half-edge 2s, from a to b of segment s, and 2s + 1, from b to a
  Index count_ = 1;
};

}  // namespace pardel::engine
