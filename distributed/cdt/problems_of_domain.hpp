// The problems of a domain whose points and segments are divided among ranks.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "../../core/part_of_points.hpp"
#include "../../core/ranks.hpp"
#include "../../core/result.hpp"
#include "../../parallel/threads/threads.hpp"
#include "../delaunay/own_points.hpp"

namespace pardel::engine {

/// A point with its number in the input.
struct NumberedPoint {
  std::uint64_t number;
  Point at;
};
/// `at`: the coordinates of the points.
[[nodiscard]] std::vector<NumberedPoint> numbered(std::span<const Point> at, const OwnPoints& own);
[[nodiscard]] std::vector<NumberedPoint> numbered(const PartOfPoints& read);

/// Collective. For a domain that seems to have a problem: the first rank gathers all of it, and looks for all problems,
/// as find_problems() in one process, but for those of markers and attributes. Done if there are none. Each point is
/// among the points of one rank. `segments`: those that this rank has read; `rest`: holes and regions.
[[nodiscard]] Status status_of_whole(const std::vector<NumberedPoint>& points, const PartOfSegments& segments,
                                     const Pslg& rest, bool convex_hull, Ranks& ranks, const Threads& threads);

}  // namespace pardel::engine
