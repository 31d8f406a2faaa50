// The points of the input that all ranks know.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "../../core/ranks.hpp"
#include "../delaunay/shared_hull.hpp"
#include "given_segment.hpp"

namespace pardel::engine {

struct CommonVertex {
  Point at;
  std::uint64_t position;
  std::uint64_t number;  ///< in the input
  int marker;            ///< 0 if it has none
  int unused = 0;
};

/// The vertices of the convex hull, and the ends of the segments that all ranks know. They have the same indices on all
/// ranks, in the order of their positions. This is also the order of the vertices in one process.
class CommonVertices {
 public:
  /// Collective; all ranks pass the same segments.
  CommonVertices(const SharedHull& hull, std::span<const GivenSegment> segments, const LocalDelaunay& delaunay,
                 const OwnPoints& own, Ranks& ranks);

  [[nodiscard]] Index size() const { return static_cast<Index>(vertices_.size()); }
  [[nodiscard]] const CommonVertex& operator[](Index i) const { return vertices_[i]; }
  /// The number of vertices before a position. So it is the index of the vertex at this position.
  [[nodiscard]] Index before(std::uint64_t position) const { return count_before(vertices_, position); }
  [[nodiscard]] bool has(std::uint64_t position) const { return at_position(vertices_, position) != nullptr; }

 private:
  std::vector<CommonVertex> vertices_;
};

}  // namespace pardel::engine
