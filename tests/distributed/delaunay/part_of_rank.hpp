// What a rank reads of the points of a test.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "../../../core/part_of_points.hpp"
#include "../../../core/pslg.hpp"
#include "../../../core/ranks.hpp"
#include "../../../properties/domains/dealt_domain.hpp"

namespace pardel {

/// Where the part of a rank begins, of n things: parts that differ in size, the last one empty if there are many ranks.
inline std::size_t begin_of_part(std::size_t n, int rank, int count) {
  if (rank == count) return n;
  return std::min(n, n * static_cast<std::size_t>(rank * rank) / static_cast<std::size_t>(count));
}

/// What a rank reads of the points.
inline PartOfPoints part_of(const Pslg& pslg, const Ranks& ranks) {
  const auto begin = [&](int rank) { return begin_of_part(pslg.points.size(), rank, ranks.count()); };
  return domains::points_between(pslg, begin(ranks.rank()), begin(ranks.rank() + 1));
}

/// The same of the segments.
inline PartOfSegments part_of_segments(const Pslg& pslg, const Ranks& ranks) {
  const auto begin = [&](int rank) { return begin_of_part(pslg.segments.size(), rank, ranks.count()); };
  return domains::segments_between(pslg, begin(ranks.rank()), begin(ranks.rank() + 1));
}

/// The same of a domain. All ranks have its holes and regions.
inline PartOfPslg part_of_domain_of(const Pslg& pslg, const Ranks& ranks) {
  return {part_of(pslg, ranks), part_of_segments(pslg, ranks), domains::rest_of(pslg)};
}

inline Pslg with_points(std::vector<Point> points) {
  Pslg pslg;
  pslg.points = std::move(points);
  return pslg;
}

}  // namespace pardel
