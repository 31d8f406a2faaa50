// The quadtree on whose leaves the points of a round are inserted if they are dense in some places.
#pragma once

#include <span>
#include <vector>

#include "../decomposition/quadtree.hpp"

namespace pardel::engine {

/// A quadtree for unevenly spread points, whose leaves have at most about `most` of them. `sample`: a part of the
/// points, evenly spread over them; `points`: the number of all. O(sample * depth of the tree).
[[nodiscard]] Quadtree quadtree_of(const Box& bounds, std::span<const Point> sample, std::size_t points, double most);

}  // namespace pardel::engine
