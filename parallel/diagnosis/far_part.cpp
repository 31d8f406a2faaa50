#include "far_part.hpp"

#include <array>
#include <span>
#include <vector>

#include "../arithmetic/box.hpp"

namespace pardel::engine {
namespace {

constexpr double far = 100;               ///< so many times the extent of the rest
constexpr std::size_t fewest_others = 4;  ///< a few points have no extent that one of them could spoil
constexpr Index several = no_index - 1;   ///< more than one segment, in a list of single segments

/// The only segment at each point; no_index for none, `several` for more.
std::vector<Index> only_segments(const Pslg& pslg) {
  std::vector<Index> only(pslg.points.size(), no_index);
  for (Index s = 0; s < pslg.segments.size(); ++s)
    for (const Index end : {pslg.segments[s].a, pslg.segments[s].b}) only[end] = only[end] == no_index ? s : several;
  return only;
}

/// The points with the smallest and the largest coordinates.
std::array<Index, 4> extreme_points(std::span<const Point> points) {
  std::array<Index, 4> extreme{};
  for (Index i = 0; i < points.size(); ++i) {
    if (points[i].x < points[extreme[0]].x) extreme[0] = i;
    if (points[i].x > points[extreme[1]].x) extreme[1] = i;
    if (points[i].y < points[extreme[2]].y) extreme[2] = i;
    if (points[i].y > points[extreme[3]].y) extreme[3] = i;
  }
  return extreme;
}

/// A point and the other end of its only segment; the point twice if it has no segment.
using Part = std::array<Index, 2>;

/// The larger side of the box around all points outside the part.
double extent_without(std::span<const Point> points, const Part& part) {
  Box box = empty_box;
  for (Index i = 0; i < points.size(); ++i)
    if (i != part[0] && i != part[1]) box.cover(Box::around(points[i]));
  return box.extent();
}

}  // namespace

std::optional<Warning> find_far_part(const Pslg& pslg) {
  if (pslg.points.empty()) return {};
  const std::vector<Index> only = only_segments(pslg);
  const double extent = extent_without(pslg.points, {no_index, no_index});
  for (const Index point : extreme_points(pslg.points)) {
    Part part = {point, point};
    if (only[point] == several) continue;
    if (only[point] != no_index) {
      const Segment& segment = pslg.segments[only[point]];
      part = {segment.a, segment.b};
      if (only[segment.a] == several || only[segment.b] == several) continue;
    }
    if (pslg.points.size() < fewest_others + (part[0] == part[1] ? 1 : 2)) continue;
    const double rest = extent_without(pslg.points, part);
    if (!(far * rest < extent)) continue;
    Warning warning{WarningKind::far_part, {}, pslg.points[point], {part[0]}, rest};
    if (part[0] != part[1]) warning.points.push_back(part[1]);
    if (only[point] != no_index) warning.segments.push_back(only[point]);
    return warning;
  }
  return {};
}

}  // namespace pardel::engine
