#include "drawn_domain.hpp"

#include <algorithm>
#include <cmath>

namespace pardel::cli {
namespace {

enum class Side { inside, outside, near };

/// Counts the sides of the outline to the right of p.
Side side_of(std::span<const Point> outline, Point p) {
  constexpr long double rounding = 1e-15L;
  bool is_inside = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Point a = outline[j], b = outline[i];
    if (p.y < std::min(a.y, b.y) || p.y > std::max(a.y, b.y)) continue;
    const long double ax = a.x, ay = a.y, px = p.x, py = p.y;
    const long double left = (b.x - ax) * (py - ay), right = (b.y - ay) * (px - ax);
    if (p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) &&
        std::abs(left - right) <= rounding * (std::abs(left) + std::abs(right)))
      return Side::near;
    if ((a.y > p.y) != (b.y > p.y) && (left - right > 0) == (b.y > a.y)) is_inside = !is_inside;
  }
  return is_inside ? Side::inside : Side::outside;
}

}  // namespace

bool lies_outside(std::span<const Point> hole, std::span<const Point> outline) {
  bool is_outside = false;
  for (const Point p : hole) {
    const Side side = side_of(outline, p);
    if (side == Side::inside) return false;
    is_outside = is_outside || side == Side::outside;
  }
  return is_outside;
}

void Drawing::add_point(Point p, const ShapeProperties& properties) {
  static_cast<void>(index_of(p));
  add_source(p, p, properties);
}

void Drawing::add_line(std::span<const Point> line, const ShapeProperties& properties) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) add_segment(line[i], line[i + 1], properties);
}

void Drawing::add_polygon(std::vector<std::vector<Point>> rings, const ShapeProperties& properties) {
  if (rings.empty()) return;
  for (const std::vector<Point>& ring : rings) {
    add_line(ring, properties);
    if (!ring.empty()) add_segment(ring.back(), ring.front(), properties);
  }
  domain_.polygons.push_back(
      {std::move(rings), properties.is_hole, properties.attribute, properties.max_area, properties.length});
}

Index Drawing::index_of(Point p) {
  const auto [found, is_new] = index_of_point_.try_emplace({p.x, p.y}, static_cast<Index>(domain_.pslg.points.size()));
  if (is_new) domain_.pslg.points.push_back(p);
  return found->second;
}

/// A piece with equal ends is a point.
void Drawing::add_source(Point from, Point to, const ShapeProperties& properties) {
  if (properties.length) domain_.sources.push_back({from, to, *properties.length, *properties.length});
}

void Drawing::add_segment(Point from, Point to, const ShapeProperties& properties) {
  add_source(from, to, properties);
  const Index a = index_of(from), b = index_of(to);
  if (a == b) return;
  std::vector<Segment>& segments = domain_.pslg.segments;
  const auto [found, is_new] = segment_between_.try_emplace(std::minmax(a, b), segments.size());
  if (is_new)
    segments.push_back({a, b, properties.marker});
  else if (segments[found->second].marker == 0)
    segments[found->second].marker = properties.marker;
  domain_.pslg.has_segment_markers = domain_.pslg.has_segment_markers || properties.has_marker;
}

}  // namespace pardel::cli
