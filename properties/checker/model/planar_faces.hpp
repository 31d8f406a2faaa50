// PlanarFaces: the faces of a planar straight-line graph. The constructor sorts half-edges around every vertex, walks
// the cycles of half-edges around faces, and places every connected component in the face directly below its leftmost
// vertex.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "../../../core/pslg.hpp"
#include "segments_below.hpp"

namespace pardel::checker {

enum class Side : std::uint8_t { left, right };

/// True if the direction from `centre` to a comes before that to b, counter-clockwise from 0 degrees. Exact.
[[nodiscard]] bool counter_clockwise_before(Point centre, Point a, Point b);

/// The representative of i, the root of its tree. Shortens the path to it.
[[nodiscard]] Index root(std::vector<Index>& parent, Index i);

/// Segments should meet at common end points only. If they do not, the faces are meaningless, but every function is
/// still safe to call.
class PlanarFaces {
 public:
  /// Preconditions: segment ids are in range, coordinates are finite, both spans outlive this object. O(n log n) time
  /// on typical input.
  PlanarFaces(std::span<const Point> points, std::span<const Segment> segments, StopSignal* stop = nullptr);

  [[nodiscard]] Index count() const { return count_; }
  /// The unbounded face.
  [[nodiscard]] static constexpr Index exterior() { return 0; }
  /// The face on one side of a segment, looking from its end a to its end b.
  [[nodiscard]] Index face(Index segment, Side side) const {
    return face_[2 * std::size_t{segment} + static_cast<std::size_t>(side)];
  }
  /// The face that contains p, or no_index if p lies on a segment. O(log n) time on typical input.
  [[nodiscard]] Index face_at(Point p) const;
  /// The segments at a vertex, counter-clockwise.
  [[nodiscard]] std::span<const Index> incident(Index vertex) const {
    return std::span(incident_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
  }

 private:
  void sort_around_vertices(SparseAsk& ask);
  void walk_cycles(SparseAsk& ask);
  void nest_components(SparseAsk& ask);

  std::span<const Point> points_;
  std::span<const Segment> segments_;
  SegmentsBelow below_;
  std::vector<std::size_t> first_;  ///< per vertex, into incident_
  std::vector<Index> incident_;
  std::vector<Index> face_;  ///< per half-edge; 2 s runs from a to b (left side), 2 s + 1 from b to a (right side)
  Index count_ = 1;
};

}  // namespace pardel::checker
