// The faces into which segments divide the plane: the faces left and right of each segment, and above it.
// Exact.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "../../core/pslg.hpp"
#include "../../core/support/stop_signal.hpp"

namespace pardel::engine {

/// Face 0 is the unbounded face, the exterior. A face can contain islands: connected components of segments. Keeps
/// references to the points and the segments. `stop` can end the construction with an exception. O(n log n).
/// Preconditions: segments meet only at common ends, which are the same point by index; coordinates are in the range of
/// the predicates; `below` is the segment directly below each point (Swept::below).
class Faces {
 public:
  static constexpr Index exterior = 0;

  Faces(std::span<const Point> points, std::span<const Segment> segments, std::span<const Index> below,
        StopSignal* stop = nullptr);

  [[nodiscard]] Index count() const { return count_; }
  /// Left and right in the direction from end a to end b.
  [[nodiscard]] Index left_of(Index segment) const { return face_[2 * std::size_t{segment}]; }
  [[nodiscard]] Index right_of(Index segment) const { return face_[2 * std::size_t{segment} + 1]; }
  /// The face directly above a segment; left of it if the segment is vertical. The exterior for no_index. So this is
  /// the face that contains a place, if `segment` is the segment directly below the place.
  [[nodiscard]] Index above(Index segment) const;

 private:
  [[nodiscard]] Index half_edge_above(Index segment) const;

  std::span<const Point> points_;
  std::span<const Segment> segments_;
  std::vector<Index> face_;  ///< left of half-edge 2s, from a to b of segment s, and 2s + 1, from b to a
  Index count_ = 1;
};

}  // namespace pardel::engine
