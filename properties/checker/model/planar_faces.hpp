// The faces of a plane straight-line graph, by definition: half-edges sorted around every vertex, face
// cycles walked, components nested in one another by what lies directly below their leftmost vertex.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "../../../core/pslg.hpp"
#include "segments_below.hpp"

namespace pardel::checker {

enum class Side : std::uint8_t { left, right };

/// Segments must meet at common end points only; where they do not, the faces mean nothing, but nothing breaks.
class PlanarFaces {
 public:
  /// O(n log n) on typical input. Segment ids must be in range, coordinates finite. Both spans must outlive this.
  PlanarFaces(std::span<const Point> points, std::span<const Segment> segments);

  [[nodiscard]] Index count() const { return count_; }
  /// The unbounded face.
  [[nodiscard]] static constexpr Index exterior() { return 0; }
  /// The face on one side of a segment, seen from its end a towards b.
  [[nodiscard]] Index face(Index segment, Side side) const {
    return face_[2 * std::size_t{segment} + static_cast<std::size_t>(side)];
  }
  /// The face that contains p; no_index for a point on a segment.
  [[nodiscard]] Index face_at(Point p) const;
  /// The segments that end at a vertex, counter-clockwise.
  [[nodiscard]] std::span<const Index> incident(Index vertex) const {
    return std::span(incident_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
  }

 private:
  void sort_around_vertices();
  void walk_cycles();
  void nest_components();

  std::span<const Point> points_;
  std::span<const Segment> segments_;
  SegmentsBelow below_;
  std::vector<std::size_t> first_;  ///< per vertex, into incident_
  std::vector<Index> incident_;
  std::vector<Index> face_;  ///< per half-edge: 2 s for a to b (left side), 2 s + 1 for b to a (right side)
  Index count_ = 1;
};

}  // namespace pardel::checker
