#include "paths.hpp"

#include <cmath>
#include <numbers>

namespace pardel::domains {

Point snapped(double x, double y) { return {std::round(x * 0x1p30) * 0x1p-30, std::round(y * 0x1p30) * 0x1p-30}; }

Point on_circle(Point centre, double radius, double degrees) {
  const double angle = degrees * (std::numbers::pi / 180);
  return snapped(centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle));
}

std::vector<Point> circle(Point centre, double radius, int pieces) {
  std::vector<Point> points;
  for (int i = 0; i < pieces; ++i) points.push_back(on_circle(centre, radius, 360.0 * i / pieces));
  return points;
}

std::vector<Point> rectangle(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

Path& Path::to(double x, double y) {
  const Point p = snapped(x, y);
  if (points.empty() || !(points.back() == p)) points.push_back(p);
  return *this;
}

Path& Path::arc(Point centre, double radius, double from_deg, double to_deg, int pieces) {
  for (int i = 0; i <= pieces; ++i) {
    const Point p = on_circle(centre, radius, from_deg + (to_deg - from_deg) * i / pieces);
    to(p.x, p.y);
  }
  return *this;
}

Index add_points(Pslg& pslg, const std::vector<Point>& points) {
  const auto first = static_cast<Index>(pslg.points.size());
  pslg.points.insert(pslg.points.end(), points.begin(), points.end());
  return first;
}

void add_open(Pslg& pslg, const std::vector<Point>& points, int marker) {
  const Index first = add_points(pslg, points);
  for (Index i = 1; i < points.size(); ++i) pslg.segments.push_back({first + i - 1, first + i, marker});
  pslg.has_segment_markers |= marker != 0;
}

void add_closed(Pslg& pslg, const std::vector<Point>& points, int marker) {
  const Index first = add_points(pslg, points);
  const auto n = static_cast<Index>(points.size());
  for (Index i = 0; i < n; ++i) pslg.segments.push_back({first + i, first + (i + 1) % n, marker});
  pslg.has_segment_markers |= marker != 0;
}

}  // namespace pardel::domains
