// The straight lines that the mesh has to keep, and the small angles between them.
#pragma once

#include <span>
#include <vector>

#include "insert_constraints.hpp"
#include "triangulation.hpp"

namespace pardel::engine {

/// A constraint with what refinement asks of it. Its pieces (subsegments) are not stored: a vertex put on a
/// line has the line as its origin, so the line of a piece follows from its ends. a < b: vertices are numbered by
/// their coordinates, so the direction that the input gives a segment has no say in how points on it are rounded.
struct Line {
  VertexId a, b;
  bool acute_at_a = false;  ///< another line leaves a at less than 90 degrees
  bool acute_at_b = false;
};

class Lines {
 public:
  Lines() = default;
  /// O(k log k). `points` are the coordinates of the ends.
  Lines(const Array<Point>& points, std::span<const Constraint> constraints);

  [[nodiscard]] const Line& operator[](Index line) const { return lines_[line]; }
  [[nodiscard]] std::size_t size() const { return lines_.size(); }

  /// The line of the constrained edge u-v; no_index when there is none (never, in a right triangulation).
  [[nodiscard]] Index line_of(const Triangulation& t, VertexId u, VertexId v) const;
  /// The end that two different lines share, or no_index.
  [[nodiscard]] VertexId shared_end(Index first, Index second) const;
  /// The cosine of the angle between two lines at their common end.
  [[nodiscard]] double cosine_at(const Array<Point>& points, VertexId apex, Index first, Index second) const;

 private:
  [[nodiscard]] std::span<const Index> at(VertexId v) const {
    if (v + 1U >= start_.size()) return {};
    return std::span(incident_).subspan(start_[v], start_[v + 1U] - start_[v]);
  }
  [[nodiscard]] VertexId other_end(Index line, VertexId end) const {
    return lines_[line].a == end ? lines_[line].b : lines_[line].a;
  }

  std::vector<Line> lines_;
  std::vector<Index> start_, incident_;  ///< the lines at each end point
};

}  // namespace pardel::engine
