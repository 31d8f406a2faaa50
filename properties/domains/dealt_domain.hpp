// The parts of a domain that ranks would have read.
#pragma once

#include <cstddef>
#include <type_traits>

#include "../../core/part_of_points.hpp"
#include "../../core/pslg.hpp"
#include "../../core/ranks.hpp"

namespace pardel::domains {

/// The points from index `first` to before index `last`.
inline PartOfPoints points_between(const Pslg& pslg, std::size_t first, std::size_t last) {
  PartOfPoints part;
  const auto slice = [&](const auto& all, std::size_t per_point) {
    using List = std::remove_cvref_t<decltype(all)>;
    if (all.empty()) return List{};
    const auto at = [&](std::size_t i) { return all.begin() + static_cast<std::ptrdiff_t>(per_point * i); };
    return List(at(first), at(last));
  };
  part.first = first;
  part.first_id = pslg.first_id;
  part.points = slice(pslg.points, 1);
  part.point_markers = slice(pslg.point_markers, 1);
  part.attributes_per_point = pslg.attributes_per_point;
  part.point_attributes = slice(pslg.point_attributes, pslg.attributes_per_point);
  return part;
}

/// The segments from index `first` to before index `last`.
inline PartOfSegments segments_between(const Pslg& pslg, std::size_t first, std::size_t last) {
  const auto at = [&](std::size_t i) { return pslg.segments.begin() + static_cast<std::ptrdiff_t>(i); };
  return {{at(first), at(last)}, first};
}

/// Holes and regions, which all ranks have.
inline Pslg rest_of(const Pslg& pslg) {
  Pslg rest;
  rest.has_segment_markers = pslg.has_segment_markers;
  rest.holes = pslg.holes;
  rest.regions = pslg.regions;
  return rest;
}

/// What a rank reads of a domain: an equal share of the points, and of the segments.
inline PartOfPslg equal_part(const Pslg& pslg, const Ranks& ranks) {
  const auto begin = [&](std::size_t n, int rank) {
    return n * static_cast<std::size_t>(rank) / static_cast<std::size_t>(ranks.count());
  };
  const int here = ranks.rank();
  const std::size_t points = pslg.points.size(), segments = pslg.segments.size();
  return {points_between(pslg, begin(points, here), begin(points, here + 1)),
          segments_between(pslg, begin(segments, here), begin(segments, here + 1)), rest_of(pslg)};
}

}  // namespace pardel::domains
