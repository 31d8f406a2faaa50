// The given points that a rank owns.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "../../core/array.hpp"
#include "../../core/ranks.hpp"
#include "../../parallel/threads/threads.hpp"
#include "../distributed.hpp"
#include "curve_division.hpp"

namespace pardel::engine {

/// Points in the order of the curve. Those of all ranks follow one another, so a point has a position among all points.
struct OwnPoints {
  Array<Point> at;
  Array<std::uint64_t> number;  ///< in the input
  Array<int> marker;            ///< empty if points have no markers
  std::size_t attributes_per_point = 0;
  Array<double> attributes;
  std::vector<std::uint64_t> first;  ///< for each rank, the position of its first point; last, the number of all points

  /// The rank that owns the point at a position.
  [[nodiscard]] int owner(std::uint64_t position) const {
    return static_cast<int>(std::ranges::upper_bound(first, position) - first.begin()) - 1;
  }
};

/// Sorts vertices by their positions. Of several with the same position, one is left.
template <class Vertex>
void sort_by_position(std::vector<Vertex>& all) {
  std::ranges::sort(all, {}, &Vertex::position);
  const auto is_same = [](const Vertex& a, const Vertex& b) { return a.position == b.position; };
  all.erase(std::unique(all.begin(), all.end(), is_same), all.end());
}

/// The number of vertices before a position. Precondition: they are sorted by position.
template <class Vertex>
[[nodiscard]] Index count_before(const std::vector<Vertex>& sorted, std::uint64_t position) {
  return static_cast<Index>(std::ranges::lower_bound(sorted, position, {}, &Vertex::position) - sorted.begin());
}

/// The vertex at a position, or nullptr. Precondition: the vertices are sorted by position.
template <class Vertex>
[[nodiscard]] const Vertex* at_position(const std::vector<Vertex>& sorted, std::uint64_t position) {
  const Index at = count_before(sorted, position);
  return at < sorted.size() && sorted[at].position == position ? &sorted[at] : nullptr;
}

/// Sends each point to its owner. Collective. Uses up the points.
[[nodiscard]] OwnPoints send_to_owners(PartOfPoints&& read, const CurveDivision& division, Ranks& ranks,
                                       const Threads& threads);

}  // namespace pardel::engine
