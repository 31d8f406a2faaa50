// Straight paths: segments that continue each other on a straight line through points at which no other segment ends.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "../../../core/pslg.hpp"
#include "../../../core/support/stop_signal.hpp"

namespace pardel::checker {

/// Divides segments into straight paths. The points of a path lie on the line through its ends to within chain_units
/// (tolerances.hpp), and in order; both are decided exactly. A mesh that is refined has subsegments for segments, and a
/// straight path is what was one segment, or several collinear ones.
class StraightPaths {
 public:
  /// Preconditions: segment ids are in range, coordinates are finite. `counts`: whether the segment belongs to the
  /// domain; others have no path and end nowhere. O(n log n) time on typical input.
  StraightPaths(std::span<const Point> points, std::span<const Segment> segments, const std::vector<bool>& counts,
                StopSignal* stop = nullptr);

  /// The two ends of the path to which a segment belongs. Precondition: the segment counts.
  [[nodiscard]] const Segment& of(Index segment) const { return ends_[path_of_[segment]]; }
  /// The ends of the path in whose interior a point lies; nothing if there is none.
  [[nodiscard]] std::optional<Segment> around(Index point) const {
    if (path_around_[point] == no_index) return std::nullopt;
    return ends_[path_around_[point]];
  }

 private:
  std::vector<Segment> ends_;       ///< per path
  std::vector<Index> path_of_;      ///< per segment
  std::vector<Index> path_around_;  ///< per point
};

}  // namespace pardel::checker
