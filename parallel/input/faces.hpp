// The faces into which segments divide the plane: the faces left and right of each segment, and the face of a point.
// Exact.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "../../core/pslg.hpp"
#include "segment_index.hpp"

namespace pardel::engine {

/// Face 0 is the unbounded face, the exterior. A face can contain islands: connected components of segments. Keeps
/// references to its arguments. O(n log n) on typical input.
/// Preconditions: segments meet only at common ends, which are the same point by index; coordinates are in the range of
/// the predicates; `index` holds the same segments.
class Faces {
 public:
  static constexpr Index exterior = 0;

  Faces(std::span<const Point> points, std::span<const Segment> segments, const SegmentIndex& index);

  [[nodiscard]] Index count() const { return count_; }
  /// Left and right in the direction from end a to end b.
  [[nodiscard]] Index left_of(Index segment) const { return face_[2 * std::size_t{segment}]; }
  [[nodiscard]] Index right_of(Index segment) const { return face_[2 * std::size_t{segment} + 1]; }
  /// Precondition: p is not on a segment.
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
