// Points of which each of several processes (ranks) has a part.
#pragma once

#include <cstdint>
#include <vector>

#include "pslg.hpp"
#include "ranks.hpp"

namespace pardel {

/// The points of one rank, for example those that it has read from a file that all ranks read together. The points of
/// rank 0 are followed by those of rank 1, and so on.
struct PartOfPoints {
  std::vector<Point> points;
  std::uint64_t first = 0;               ///< the number of the first of them among all points, counted from 0
  std::size_t attributes_per_point = 0;  ///< the same on all ranks
  std::vector<double> point_attributes;  ///< point by point
  std::vector<int> point_markers;        ///< one per point; empty on all ranks if points have none
  FirstId first_id{};                    ///< only messages use it
};

/// The segments of one rank, numbered rank by rank like the points of PartOfPoints.
struct PartOfSegments {
  std::vector<Segment> segments;  ///< they name the points of all ranks by their numbers
  std::uint64_t first = 0;        ///< the number of the first of them among all segments, counted from 0
};

/// A domain whose points and segments are divided among ranks. All ranks have the rest of it.
struct PartOfPslg {
  PartOfPoints points;
  PartOfSegments segments{};
  /// Holes, regions, and whether segments have markers. It has no points and no segments.
  Pslg rest{};
};

/// True, on all ranks, if the domain has points only: no segments, holes or regions. Collective.
[[nodiscard]] inline bool is_point_set(const PartOfPslg& domain, Ranks& ranks) {
  std::uint64_t segments = domain.segments.segments.size();
  ranks.add_up({&segments, 1});
  return segments == 0 && is_point_set(domain.rest);
}

}  // namespace pardel
