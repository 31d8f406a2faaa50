#include "input_faces.hpp"

#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace pardel::fuzz {
namespace {

using ref::ExactPoint;
using ref::Number;

/// The sides of the convex hull, divided at the points on them, without those that are segments.
std::vector<Wall> sides_of_hull(const Pslg& pslg) {
  std::map<ExactPoint, Index> index;  // from left to right, so in order along each side
  std::vector<ExactPoint> points, corners;
  for (Index i = 0; i < pslg.points.size(); ++i) {
    points.push_back(ref::exact(pslg.points[i]));
    index.emplace(points.back(), i);
  }
  std::set<ref::Edge> segments;
  for (const Segment& s : pslg.segments) segments.insert(ref::edge(s.a, s.b));
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(corners));
  std::vector<Wall> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto [from, to] = std::minmax(corners[i], corners[(i + 1) % corners.size()]);
    Index last = index.at(from);
    for (auto at = index.upper_bound(from); at != index.end() && at->first <= to; ++at) {
      if (CGAL::orientation(from, to, at->first) != CGAL::COLLINEAR) continue;
      if (!segments.contains(ref::edge(last, at->second))) sides.push_back({last, at->second, no_index, 0});
      last = at->second;
    }
  }
  return sides;
}

std::vector<Wall> walls_of(const Pslg& pslg, bool convex_hull) {
  std::vector<Wall> walls;
  for (Index s = 0; s < pslg.segments.size(); ++s)
    walls.push_back({pslg.segments[s].a, pslg.segments[s].b, s, pslg.segments[s].marker});
  if (convex_hull || pslg.segments.empty())
    for (const Wall& side : sides_of_hull(pslg)) walls.push_back(side);
  return walls;
}

std::vector<PlaneFaces::Line> lines_of(const Pslg& pslg, const std::vector<Wall>& walls) {
  std::vector<PlaneFaces::Line> lines;
  lines.reserve(walls.size());
  for (const Wall& wall : walls) lines.emplace_back(ref::exact(pslg.points[wall.a]), ref::exact(pslg.points[wall.b]));
  return lines;
}

}  // namespace

InputFaces::InputFaces(const Pslg& pslg, bool convex_hull)
    : walls_(walls_of(pslg, convex_hull)), faces_(lines_of(pslg, walls_)) {
  outside_.insert(faces_.outside());
  for (const Point seed : pslg.holes) outside_.insert(face_at(ref::exact(seed)));
  for (const Region& region : pslg.regions) face_of_region_.push_back(face_at(ref::exact(region.seed)));
  for (Wall& wall : walls_) {
    const ExactPoint a = ref::exact(pslg.points[wall.a]), b = ref::exact(pslg.points[wall.b]);
    wall.left = faces_.left_of(a, b);
    wall.right = faces_.left_of(b, a);
    wall.left_inside = is_inside(wall.left);
    wall.right_inside = is_inside(wall.right);
  }
}

bool InputFaces::contains(const ExactPoint& p) const {
  return std::ranges::any_of(faces_.around(p), [&](Face face) { return is_inside(face); });
}

std::set<Index> InputFaces::regions_in(Face face) const {
  std::set<Index> regions;
  for (Index r = 0; r < face_of_region_.size(); ++r)
    if (face_of_region_[r] == face) regions.insert(r);
  return regions;
}

Number InputFaces::area() const {
  Number sum = 0;
  for (Face face = 0; face < faces_.count(); ++face)
    if (is_inside(face)) sum += faces_.area(face);
  return sum;
}

}  // namespace pardel::fuzz
