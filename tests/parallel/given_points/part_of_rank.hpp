// What a rank reads of the points of a test.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "../../../core/part_of_points.hpp"
#include "../../../core/pslg.hpp"
#include "../../../core/ranks.hpp"
#include "../../../properties/theorems/framework/dealt_points.hpp"

namespace pardel {

/// What a rank reads of the points: parts that differ in size, the last one without points if there are many ranks.
inline PartOfPoints part_of(const Pslg& pslg, const Ranks& ranks) {
  const std::size_t n = pslg.points.size();
  const auto bound = [&](int rank) {
    if (rank == ranks.count()) return n;
    return std::min(n, n * static_cast<std::size_t>(rank * rank) / static_cast<std::size_t>(ranks.count()));
  };
  return properties::points_between(pslg, bound(ranks.rank()), bound(ranks.rank() + 1));
}

/// The same of a domain. All ranks have its segments, holes and regions.
inline PartOfPslg part_of_domain_of(const Pslg& pslg, const Ranks& ranks) {
  return {part_of(pslg, ranks), properties::without_points(pslg)};
}

inline Pslg with_points(std::vector<Point> points) {
  Pslg pslg;
  pslg.points = std::move(points);
  return pslg;
}

}  // namespace pardel
