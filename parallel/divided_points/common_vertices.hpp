// The points of the input that all ranks know.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "../../core/pslg.hpp"
#include "../../core/ranks.hpp"
#include "../given_points/local_delaunay.hpp"
#include "../given_points/own_points.hpp"
#include "../given_points/shared_hull.hpp"

namespace pardel::engine {

struct CommonVertex {
  Point at;
  std::uint64_t position;
  std::uint64_t number;  ///< in the input
  int marker;            ///< 0 if it has none
  int unused = 0;
};

/// Sorts what has positions. Of several with the same position, one is left.
template <class T>
void sort_by_position(std::vector<T>& all) {
  std::ranges::sort(all, {}, &T::position);
  const auto is_same = [](const T& a, const T& b) { return a.position == b.position; };
  all.erase(std::unique(all.begin(), all.end(), is_same), all.end());
}

/// The vertices of the convex hull, and the ends of the segments. They have the same indices on all ranks, in the order
/// of their positions. This is also the order of the vertices in one process.
class CommonVertices {
 public:
  /// Collective; all ranks pass the same segments, which name points by their numbers.
  CommonVertices(const SharedHull& hull, std::span<const Segment> segments, const LocalDelaunay& delaunay,
                 const OwnPoints& own, Ranks& ranks);

  [[nodiscard]] Index size() const { return static_cast<Index>(vertices_.size()); }
  [[nodiscard]] const CommonVertex& operator[](Index i) const { return vertices_[i]; }
  /// The number of vertices before a position. So it is the index of the vertex at this position.
  [[nodiscard]] Index before(std::uint64_t position) const {
    return static_cast<Index>(std::ranges::lower_bound(vertices_, position, {}, &CommonVertex::position) -
                              vertices_.begin());
  }
  [[nodiscard]] bool has(std::uint64_t position) const {
    const Index at = before(position);
    return at < vertices_.size() && vertices_[at].position == position;
  }
  /// The segments, with indices of these vertices as ends. no_index for a point that does not exist.
  [[nodiscard]] const std::vector<Segment>& segments() const { return segments_; }

 private:
  std::vector<CommonVertex> vertices_;
  std::vector<Segment> segments_;
};

}  // namespace pardel::engine
