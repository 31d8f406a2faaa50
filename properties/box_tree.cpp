#include "box_tree.hpp"

#include <numeric>

#include "exact.hpp"

namespace pardel {

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), Index{0});
  if (!boxes_.empty()) build(0, static_cast<std::uint32_t>(boxes_.size()));
}

std::uint32_t BoxTree::build(std::uint32_t first, std::uint32_t last) {
  const auto at = static_cast<std::uint32_t>(nodes_.size());
  Box box;
  for (std::uint32_t i = first; i < last; ++i) box.include(boxes_[order_[i]]);
  nodes_.push_back({box, first, last, 0, 0});
  if (last - first <= leaf_size) return at;

  // Halve by the median centre along the longer side.
  const bool wide = box.max_x - box.min_x >= box.max_y - box.min_y;
  const auto centre = [&](Index item) {
    const Box& b = boxes_[item];
    return wide ? b.min_x / 2 + b.max_x / 2 : b.min_y / 2 + b.max_y / 2;
  };
  const std::uint32_t middle = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                   [&](Index a, Index b) { return centre(a) < centre(b); });
  const std::uint32_t left = build(first, middle);
  const std::uint32_t right = build(middle, last);
  nodes_[at].left = left;
  nodes_[at].right = right;
  return at;
}

namespace {

std::vector<Box> boxes_of(std::span<const Point> points, std::span<const Segment> segments) {
  std::vector<Box> boxes(segments.size());
  for (std::size_t s = 0; s < segments.size(); ++s) {
    boxes[s].include(points[segments[s].a]);
    boxes[s].include(points[segments[s].b]);
  }
  return boxes;
}

}  // namespace

SegmentsBelow::SegmentsBelow(std::span<const Point> points, std::span<const Segment> segments)
    : points_(points), segments_(segments), tree_(boxes_of(points, segments)) {}

SegmentsBelow::Ends SegmentsBelow::ends(Index segment) const {
  const Point a = points_[segments_[segment].a];
  const Point b = points_[segments_[segment].b];
  return a.x <= b.x ? Ends{a, b} : Ends{b, a};
}

bool SegmentsBelow::is_above(Index s, Index t) const {
  // Both span one abscissa and do not cross: the end that lies within the other's span decides, and the
  // other end where the first one lies on the other segment.
  const Ends upper = ends(s);
  const Ends lower = ends(t);
  if (upper.left.x < lower.left.x) {
    const int side = exactly::orientation(upper.left, upper.right, lower.left);
    if (side != 0) return side < 0;
    return exactly::orientation(upper.left, upper.right, lower.right) < 0;
  }
  const int side = exactly::orientation(lower.left, lower.right, upper.left);
  if (side != 0) return side > 0;
  return exactly::orientation(lower.left, lower.right, upper.right) > 0;
}

Index SegmentsBelow::directly_below(Point p) const {
  Index best = no_index;
  double floor = -std::numeric_limits<double>::infinity();  // what ends below this is below the best
  const auto spans = [&](const Box& box) {
    return box.min_x < p.x && p.x <= box.max_x && box.min_y < p.y && box.max_y >= floor;
  };
  tree_.visit(spans, [&](Index segment) {
    const Ends line = ends(segment);
    if (exactly::orientation(line.left, line.right, p) <= 0) return;
    if (best != no_index && !is_above(segment, best)) return;
    best = segment;
    floor = tree_.box(segment).min_y;
  });
  return best;
}

Index SegmentsBelow::through(Point p) const {
  Index found = no_index;
  Box at;
  at.include(p);
  tree_.visit([&](const Box& box) { return box.meets(at); },
              [&](Index segment) {
                const Ends line = ends(segment);
                if (exactly::orientation(line.left, line.right, p) == 0) found = segment;
              });
  return found;
}

}  // namespace pardel
