#include "straight_paths.hpp"

#include <array>

#include "../../../core/support/straight_points.hpp"
#include "../arithmetic/exact.hpp"
#include "../tolerances.hpp"

namespace pardel::checker {
namespace {

bool is_straight(std::span<const Point> points, std::span<const Index> path) {
  const Point a = points[path.front()], b = points[path.back()];
  const Units units = units_of_segment(a, b), allowed{chain_units * units.x, chain_units * units.y};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point from = points[path[i - 1]], to = points[path[i]];
    if (exactly::progress(from, to, a, b) <= 0 || exactly::line_offset_exceeds(to, a, b, allowed)) return false;
  }
  return true;
}

}  // namespace

StraightPaths::StraightPaths(std::span<const Point> points, std::span<const Segment> segments,
                             const std::vector<bool>& counts, StopSignal* stop)
    : path_of_(segments.size(), no_index), path_around_(points.size(), no_index) {
  std::vector<Index> number;  // of the segments that count
  std::vector<Segment> counted;
  for (Index s = 0; s < segments.size(); ++s) {
    if (!counts[s]) continue;
    number.push_back(s);
    counted.push_back(segments[s]);
  }
  const std::vector<bool> is_inner = straight_points(
      points, counted, [&](std::span<const Index> path) { return is_straight(points, path); }, stop);
  std::vector<std::array<Index, 2>> at(points.size(), {no_index, no_index});  // the two segments at an inner point
  for (Index i = 0; i < counted.size(); ++i)
    for (const Index v : {counted[i].a, counted[i].b})
      if (is_inner[v]) at[v][at[v][0] == no_index ? 0 : 1] = i;

  SparseAsk ask(stop);
  const auto follow = [&](Index i, Index start) {
    Index v = start;
    for (;;) {
      ask();
      path_of_[number[i]] = static_cast<Index>(ends_.size());
      v = counted[i].a == v ? counted[i].b : counted[i].a;
      if (!is_inner[v]) break;
      path_around_[v] = static_cast<Index>(ends_.size());
      i = at[v][0] == i ? at[v][1] : at[v][0];
    }
    ends_.push_back({start, v});
  };
  for (Index i = 0; i < counted.size(); ++i)
    for (const Index v : {counted[i].a, counted[i].b})
      if (path_of_[number[i]] == no_index && !is_inner[v]) follow(i, v);
}

}  // namespace pardel::checker
