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

/// The points on the outline drawn so far: corners of the hull, and what they were merged into.
using Corners = std::set<Index>;

/// Draws the sides of the hull that do not join two corners of the outline drawn so far. False if there is no such side
/// or, of the first sides, if no point is near one.
bool draw_sides(Work& work, Corners& corners, const Snapping& snapping, StopSignal& stop) {
  if (all_collinear(work.pslg.points, {1, &stop})) return false;
  std::vector<Segment> sides = sides_of_hull(work.pslg, stop);
  std::erase_if(sides, [&](const Segment& s) { return corners.contains(s.a) && corners.contains(s.b); });
  if (sides.empty()) return false;
  Work drawn{work.pslg, identity_map(work.pslg.points.size()), work.source};
  drawn.pslg.segments.insert(drawn.pslg.segments.end(), sides.begin(), sides.end());
  drawn.source.resize(drawn.pslg.segments.size(), no_index);
  if (!untangle(drawn, snapping, stop) || (corners.empty() && are_whole(sides, drawn))) return false;
  Corners met;
  for (const Index corner : corners) met.insert(drawn.point_map[corner]);
  for (const Segment& side : sides) met.insert({drawn.point_map[side.a], drawn.point_map[side.b]});
  corners = std::move(met);
  for (Index& point : work.point_map) point = drawn.point_map[point];
  work.pslg = std::move(drawn.pslg);
  work.source = std::move(drawn.source);
  return true;
}

/// True if only one segment ends at some corner. The hull is then so narrow there that its sides fell into one.
bool is_open(const Corners& corners, const Pslg& pslg) {
  std::vector<int> ends(pslg.points.size(), 0);
  for (const Segment& s : pslg.segments)
    for (const Index end : {s.a, s.b}) ++ends[end];
  return std::ranges::any_of(corners, [&](Index corner) { return ends[corner] == 1; });
}

}  // namespace

bool draw_hull_if_points_are_near(Work& work, const Snapping& snapping, StopSignal& stop) {
  if (snapping.is_zero()) return false;
  // Corners of the hull can be merged into points inside of it. Then it has other corners. A side between corners that
  // are on the outline is not drawn again: points beside it may have become so near to others that it passes them by.
  constexpr int most_rounds = 8;
  Corners corners;
  Work drawn = work;
  int rounds = 0;
  while (rounds < most_rounds && draw_sides(drawn, corners, snapping, stop)) ++rounds;
  if (corners.empty() || is_open(corners, drawn.pslg)) return false;
  work = std::move(drawn);
  return true;
}

}  // namespace pardel::engine
