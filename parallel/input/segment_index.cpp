#include "segment_index.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "../arithmetic/predicates.hpp"
#include "../concurrency/hilbert_order.hpp"

namespace pardel::engine {
namespace {

struct LeftToRight {
  Point left, right;
};
LeftToRight left_to_right(std::span<const Point> points, const Segment& s) {
  const Point a = points[s.a], b = points[s.b];
  return a.x <= b.x ? LeftToRight{a, b} : LeftToRight{b, a};
}

}  // namespace

SegmentIndex::SegmentIndex(std::span<const Point> points, std::span<const Segment> segments)
    : points_(points), segments_(segments) {
  if (segments.empty()) return;
  std::vector<Point> middles;
  middles.reserve(segments.size());
  for (const Segment& s : segments)
    middles.push_back({points[s.a].x / 2 + points[s.b].x / 2, points[s.a].y / 2 + points[s.b].y / 2});
  order_ = hilbert_order(middles);

  levels_.emplace_back();
  for (const Index s : order_) levels_[0].push_back(Box::around(points[segments[s].a], points[segments[s].b]));
  while (levels_.back().size() > 1) {
    const std::vector<Box>& lower = levels_.back();
    std::vector<Box> upper;
    for (std::size_t i = 0; i < lower.size(); ++i) {
      if (i % fan == 0) upper.push_back(lower[i]);
      upper.back().cover(lower[i]);
    }
    levels_.push_back(std::move(upper));
  }
}

Index SegmentIndex::through(Point p) const {
  Index found = no_index;
  for_each_near(Box::around(p), [&](Index s) {
    if (orient2d(points_[segments_[s].a], points_[segments_[s].b], p) == 0) found = s;
    return found == no_index;
  });
  return found;
}

/// True if the segment meets the ray that below() describes.
bool SegmentIndex::is_below(Index segment, Point p) const {
  const auto [left, right] = left_to_right(points_, segments_[segment]);
  return left.x < p.x && p.x <= right.x && orient2d(left, right, p) > 0;
}

/// Preconditions: a vertical line crosses both segments, and they have at most an end in common. Tests the left end
/// that is in the x range of the other segment. If this is a common end, tests a right end instead.
bool SegmentIndex::is_higher(Index segment, Index than) const {
  const auto [left, right] = left_to_right(points_, segments_[segment]);
  const auto [other_left, other_right] = left_to_right(points_, segments_[than]);
  const double at_left =
      left.x >= other_left.x ? orient2d(other_left, other_right, left) : -orient2d(left, right, other_left);
  if (at_left != 0) return at_left > 0;
  return (right.x <= other_right.x ? orient2d(other_left, other_right, right) : -orient2d(left, right, other_right)) >
         0;
}

/// A close lower bound of the segment's y at x. The interpolation has an error of less than 32 roundings.
double SegmentIndex::least_height(Index segment, double x) const {
  const auto [left, right] = left_to_right(points_, segments_[segment]);
  const double height = left.y + (x - left.x) / (right.x - left.x) * (right.y - left.y);
  return height - 0x1p-48 * (std::abs(left.y) + std::abs(right.y));
}

Index SegmentIndex::below(Point p) const {
  if (levels_.empty()) return no_index;
  Index best = no_index;
  double best_height = -std::numeric_limits<double>::infinity();
  const auto may_hold_better = [&](const Box& box) {
    return box.min_x < p.x && p.x <= box.max_x && box.min_y <= p.y && box.max_y >= best_height;
  };
  Stack stack;
  std::size_t waiting = 0;
  stack[waiting++] = {levels_.size() - 1, 0};
  while (waiting > 0) {
    const Node node = stack[--waiting];
    if (!may_hold_better(bounds(node))) continue;
    if (node.level == 0) {
      const Index segment = order_[node.index];
      if (!is_below(segment, p) || (best != no_index && !is_higher(segment, best))) continue;
      best = segment;
      best_height = least_height(segment, p.x);
      continue;
    }
    const std::size_t first = waiting;
    for (std::size_t child = node.index * fan; child < end_of_children(node); ++child)
      if (may_hold_better(levels_[node.level - 1][child])) stack[waiting++] = {node.level - 1, child};
    // Visit the highest box first: boxes below the best segment are then skipped.
    std::sort(stack.data() + first, stack.data() + waiting,
              [&](Node a, Node b) { return bounds(a).max_y < bounds(b).max_y; });
  }
  return best;
}

}  // namespace pardel::engine
