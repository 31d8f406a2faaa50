// The pieces of the segments of a mesh that is refined.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "../../core/array.hpp"
#include "../../core/pslg.hpp"

namespace pardel::engine {

/// The subsegments of which each segment consisted when the refinement of a mesh began.
class SegmentPieces {
 public:
  struct Piece {
    Index a, b;    ///< the vertices at its ends
    Index number;  ///< the index of the subsegment, as given to add()
  };

  /// Adds the pieces of the next segment: `path` is its vertices from end to end, `numbers` the subsegments between
  /// them.
  void add(std::span<const Index> path, std::span<const Index> numbers) {
    path_.insert(path_.end(), path.begin(), path.end());
    number_.insert(number_.end(), numbers.begin(), numbers.end());
    number_.push_back(no_index);  // so that both lists have the same indices
    first_.push_back(path_.size());
  }
  [[nodiscard]] bool empty() const { return path_.empty(); }

  /// The piece of a segment on which p lies, a point of the segment that is no end of a piece. O(log n) for n pieces.
  [[nodiscard]] Piece at(const Array<Point>& points, Index segment, Point p) const {
    const auto path = std::span(path_).subspan(first_[segment], first_[segment + 1] - first_[segment]);
    const Point a = points[path.front()], b = points[path.back()];
    // Along the axis on which the segment is longer, its vertices are in order in spite of rounding.
    const bool by_x = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
    const auto place = [&](Point q) { return by_x ? q.x : q.y; };
    const bool ascends = place(a) < place(b);
    const auto after = std::partition_point(path.begin() + 1, path.end() - 1, [&](Index v) {
      return ascends ? place(points[v]) <= place(p) : place(points[v]) >= place(p);
    });
    const auto i = static_cast<std::size_t>(after - path.begin());
    return {path[i - 1], path[i], number_[first_[segment] + i - 1]};
  }

 private:
  std::vector<std::size_t> first_{0};
  std::vector<Index> path_;
  std::vector<Index> number_;
};

}  // namespace pardel::engine
