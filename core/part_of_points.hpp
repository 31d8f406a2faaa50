// Points of which each of several processes (ranks) has a part.
#pragma once

#include <cstdint>
#include <vector>

#include "pslg.hpp"

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

/// A domain whose points are divided among ranks. All ranks have the rest of it.
struct PartOfPslg {
  PartOfPoints points;
  /// Segments, holes and regions. It has no points: segments name those of all ranks by their numbers.
  Pslg rest{};
};

}  // namespace pardel
