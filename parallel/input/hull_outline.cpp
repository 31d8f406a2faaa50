// The outline of a domain that is the convex hull of its points, if points lie near sides of the hull.
#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "convex_hull.hpp"
#include "untangle.hpp"

namespace pardel::engine {
namespace {

std::vector<Segment> sides_of_hull(const Pslg& pslg, StopSignal& stop) {
  const std::vector<Index> hull = convex_hull(pslg.points, {1, &stop});
  std::vector<Segment> sides;
  for (std::size_t i = 0; i < hull.size(); ++i) sides.push_back({hull[i], hull[(i + 1) % hull.size()]});
  return sides;
}

/// True if a segment joins the ends of each side. The points may have new numbers.
bool are_whole(const std::vector<Segment>& sides, const Work& drawn) {
  std::set<std::pair<Index, Index>> joined;
  for (const Segment& s : drawn.pslg.segments) joined.insert(std::minmax(s.a, s.b));
  return std::ranges::all_of(sides, [&](const Segment& side) {
    return joined.contains(std::minmax(drawn.point_map[side.a], drawn.point_map[side.b]));
  });
}

/// Draws the sides of the hull once. False if no point is near a side.
bool draw_sides(Work& work, const Snapping& snapping, StopSignal& stop) {
  if (all_collinear(work.pslg.points, {1, &stop})) return false;
  const std::vector<Segment> sides = sides_of_hull(work.pslg, stop);
  Work drawn{work.pslg, identity_map(work.pslg.points.size()), work.source};
  drawn.pslg.segments.insert(drawn.pslg.segments.end(), sides.begin(), sides.end());
  drawn.source.resize(drawn.pslg.segments.size(), no_index);
  if (!untangle(drawn, snapping, stop) || are_whole(sides, drawn)) return false;
  for (Index& point : work.point_map) point = drawn.point_map[point];
  work.pslg = std::move(drawn.pslg);
  work.source = std::move(drawn.source);
  return true;
}

}  // namespace

bool draw_hull_if_points_are_near(Work& work, const Snapping& snapping, StopSignal& stop) {
  if (snapping.is_zero()) return false;
  // Corners of the hull can be merged into points inside of it. Then it has other sides.
  constexpr int most_rounds = 8;
  bool is_drawn = false;
  for (int round = 0; round < most_rounds; ++round) {
    const Pslg before = work.pslg;
    if (!draw_sides(work, snapping, stop)) break;
    is_drawn = true;
    if (work.pslg == before) break;
  }
  return is_drawn;
}

}  // namespace pardel::engine
