// The sweep finds the points near segments that are not steep. A second sweep, with exchanged coordinates, finds them
// near the other segments.
#include <algorithm>

#include "plane_sweep.hpp"

namespace pardel::engine {

std::vector<NearPoint> find_near_points(const SweepInput& input, const Swept& swept) {
  const auto transposed = [](std::span<const Point> points) {
    std::vector<Point> result;
    result.reserve(points.size());
    for (const Point& p : points) result.push_back({p.y, p.x});
    return result;
  };
  const std::vector<Point> points = transposed(input.points), queries = transposed(input.queries);
  SweepInput other = input;
  other.points = points;
  other.queries = queries;
  std::vector<NearPoint> near = sweep_plane(other).near;
  near.insert(near.end(), swept.near.begin(), swept.near.end());
  std::ranges::sort(near);
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

}  // namespace pardel::engine
