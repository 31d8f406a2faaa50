// What a rank reads of the points of a test.
#pragma once

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

#include "../../../core/part_of_points.hpp"
#include "../../../core/pslg.hpp"
#include "../../../core/ranks.hpp"

namespace pardel {

/// What a rank reads of the points: parts that differ in size, the last one without points if there are many ranks.
inline PartOfPoints part_of(const Pslg& pslg, const Ranks& ranks) {
  const std::size_t n = pslg.points.size(), k = pslg.attributes_per_point;
  const auto bound = [&](int rank) {
    return std::min(n, n * static_cast<std::size_t>(rank * rank) / static_cast<std::size_t>(ranks.count()));
  };
  const std::size_t first = bound(ranks.rank()), last = ranks.rank() + 1 == ranks.count() ? n : bound(ranks.rank() + 1);
  PartOfPoints part;
  const auto slice = [&](const auto& all, std::size_t each) {
    using List = std::remove_cvref_t<decltype(all)>;
    if (all.empty()) return List{};
    const auto at = [&](std::size_t i) { return all.begin() + static_cast<std::ptrdiff_t>(each * i); };
    return List(at(first), at(last));
  };
  part.first = first;
  part.points = slice(pslg.points, 1);
  part.point_markers = slice(pslg.point_markers, 1);
  part.attributes_per_point = k;
  part.point_attributes = slice(pslg.point_attributes, k);
  return part;
}

/// The same of a domain. All ranks have its segments, holes and regions.
inline PartOfPslg part_of_domain_of(const Pslg& pslg, const Ranks& ranks) {
  PartOfPslg part{part_of(pslg, ranks), pslg};
  part.rest.points.clear();
  part.rest.point_markers.clear();
  part.rest.point_attributes.clear();
  part.rest.attributes_per_point = 0;
  return part;
}

inline Pslg with_points(std::vector<Point> points) {
  Pslg pslg;
  pslg.points = std::move(points);
  return pslg;
}

}  // namespace pardel
