#include "background.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "../concurrency/hilbert_order.hpp"

namespace pardel::engine {
namespace {

double squared_distance(const Box& box, Point p) {
  const double dx = std::max({box.min_x - p.x, 0.0, p.x - box.max_x});
  const double dy = std::max({box.min_y - p.y, 0.0, p.y - box.max_y});
  return dx * dx + dy * dy;
}

/// The point of the segment a-b nearest to p, as a fraction of the segment from a.
double nearest_fraction(Point a, Point b, Point p) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double length = dx * dx + dy * dy;
  return length > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length, 0.0, 1.0) : 0.0;
}

}  // namespace

Background::Background(std::span<const Point> points, std::vector<std::array<Index, 3>> triangles,
                       const Threads& threads)
    : points_(points.begin(), points.end()), leaf_count_(std::bit_ceil(std::max<std::size_t>(1, triangles.size()))) {
  SparseAsk ask(threads.stop);
  std::vector<Point> centre;
  centre.reserve(triangles.size());
  for (const auto& v : triangles) {
    ask();
    const Point a = points_[v[0]], b = points_[v[1]], c = points_[v[2]];
    centre.push_back({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3});
  }
  number_ = hilbert_order(centre, threads);
  boxes_.assign(2 * leaf_count_, empty_box);
  for (std::size_t i = 0; i < number_.size(); ++i) {
    ask();
    triangles_.push_back(triangles[number_[i]]);
    Box& box = boxes_[leaf_count_ + i];
    for (const Index v : triangles_.back()) box.cover(Box::around(points_[v]));
  }
  for (std::size_t i = leaf_count_ - 1; i > 0; --i) {
    ask();
    boxes_[i].cover(boxes_[2 * i]);
    boxes_[i].cover(boxes_[2 * i + 1]);
  }
}

Located Background::weights_in(Index leaf, Point p) const {
  const auto& v = triangles_[leaf];
  const std::array<Point, 3> c{points_[v[0]], points_[v[1]], points_[v[2]]};
  Located result{number_[leaf], v, {}};
  const auto cross = [](Point a, Point b, Point q) { return (b.x - a.x) * (q.y - a.y) - (b.y - a.y) * (q.x - a.x); };
  const double area = cross(c[0], c[1], c[2]);
  bool inside = area > 0;
  for (unsigned i = 0; i < 3; ++i) {
    result.weight[i] = cross(c[(i + 1) % 3], c[(i + 2) % 3], p) / area;
    inside = inside && result.weight[i] >= 0;
  }
  if (inside) return result;

  double best = INFINITY;
  for (unsigned i = 0; i < 3; ++i) {
    const unsigned j = (i + 1) % 3;
    const double f = nearest_fraction(c[i], c[j], p);
    const double x = c[i].x + f * (c[j].x - c[i].x) - p.x, y = c[i].y + f * (c[j].y - c[i].y) - p.y;
    if (x * x + y * y >= best) continue;
    best = x * x + y * y;
    result.weight = {};
    result.weight[i] = 1 - f;
    result.weight[j] = f;
  }
  return result;
}

Located Background::locate(Point p) const {
  Located best;
  double best_distance = INFINITY;
  std::vector<std::size_t> stack{1};
  while (!stack.empty()) {
    const std::size_t node = stack.back();
    stack.pop_back();
    if (squared_distance(boxes_[node], p) >= best_distance) continue;
    if (node < leaf_count_) {
      const bool left_first = squared_distance(boxes_[2 * node], p) <= squared_distance(boxes_[2 * node + 1], p);
      stack.push_back(2 * node + (left_first ? 1 : 0));
      stack.push_back(2 * node + (left_first ? 0 : 1));
      continue;
    }
    if (node - leaf_count_ >= triangles_.size()) continue;
    const Located here = weights_in(static_cast<Index>(node - leaf_count_), p);
    Point q{0, 0};
    for (unsigned i = 0; i < 3; ++i) {
      q.x += here.weight[i] * points_[here.v[i]].x;
      q.y += here.weight[i] * points_[here.v[i]].y;
    }
    const bool inside = here.weight[0] > 0 && here.weight[1] > 0 && here.weight[2] > 0;
    const double distance = inside ? 0 : (q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y);
    if (distance < best_distance) {
      best = here;
      best_distance = distance;
    }
  }
  return best;
}

double Background::interpolate(Point p, std::span<const double> value_per_point) const {
  const Located at = locate(p);
  double value = 0;
  for (unsigned i = 0; i < 3; ++i) value += at.weight[i] * value_per_point[at.v[i]];
  return value;
}

}  // namespace pardel::engine
