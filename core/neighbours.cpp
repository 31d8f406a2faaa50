#include "neighbours.hpp"

#include <algorithm>

namespace pardel {
namespace {

/// Side 3t + i is the edge opposite corner i of triangle t.
struct Ends {
  Index low;
  Index high;
};

Ends ends_of(const Array<Triangle>& triangles, Index side) {
  const auto& v = triangles[side / 3].v;
  const auto [low, high] = std::minmax(v[(side + 1) % 3], v[(side + 2) % 3]);
  return {low, high};
}

}  // namespace

// A counting sort groups the sides by their lower end. Within a group, a table indexed by the higher end finds the
// other side of the same edge. A second pass over the same group clears the table.
std::size_t rebuild_neighbours(Array<Triangle>& triangles, std::size_t points) {
  const auto sides = static_cast<Index>(3 * triangles.size());
  Array<Index> start(points + 1, 0);
  for (Index s = 0; s < sides; ++s) ++start[ends_of(triangles, s).low];
  for (std::size_t p = 0, sum = 0; p <= points; ++p) start[p] = static_cast<Index>(sum += start[p]);
  Array<Index> by_low_end(sides, 0);
  for (Index s = sides; s-- > 0;) by_low_end[--start[ends_of(triangles, s).low]] = s;

  Array<Index> open(points, no_index);  // indexed by the higher end: the first side of this edge, or `closed`
  constexpr Index closed = no_index - 1;
  std::size_t surplus = 0;
  for (std::size_t p = 0; p < points; ++p) {
    const auto around = by_low_end.span().subspan(start[p], start[p + 1] - start[p]);
    for (const Index s : around) {
      Index& waiting = open[ends_of(triangles, s).high];
      triangles[s / 3].n[s % 3] = no_index;
      if (waiting == no_index) {
        waiting = s;
      } else if (waiting == closed || waiting / 3 == s / 3) {
        ++surplus;
      } else {
        triangles[s / 3].n[s % 3] = waiting / 3;
        triangles[waiting / 3].n[waiting % 3] = s / 3;
        waiting = closed;
      }
    }
    for (const Index s : around) open[ends_of(triangles, s).high] = no_index;
  }
  return surplus;
}

}  // namespace pardel
