#include "segments_below.hpp"

#include <limits>
#include <vector>

#include "../arithmetic/exact.hpp"

namespace pardel::checker {
namespace {

std::vector<BoundingBox> boxes_of(std::span<const Point> points, std::span<const Segment> segments) {
  std::vector<BoundingBox> boxes(segments.size());
  for (std::size_t s = 0; s < segments.size(); ++s) {
    boxes[s].include(points[segments[s].a]);
    boxes[s].include(points[segments[s].b]);
  }
  return boxes;
}

}  // namespace

SegmentsBelow::SegmentsBelow(std::span<const Point> points, std::span<const Segment> segments, StopSignal* stop)
    : points_(points), segments_(segments), tree_(boxes_of(points, segments), stop) {}

SegmentsBelow::Ends SegmentsBelow::ends(Index segment) const {
  const Point a = points_[segments_[segment].a];
  const Point b = points_[segments_[segment].b];
  return a.x <= b.x ? Ends{a, b} : Ends{b, a};
}

bool SegmentsBelow::is_above(Index s, Index t) const {
  // Some vertical line meets both segments, and they do not cross. Of the two left ends, the one further right is
  // compared with the other segment. If it lies on the other segment, the right end of its own segment is compared.
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
  double floor =
      -std::numeric_limits<double>::infinity();  // segments whose box ends below this value lie below the best
  const auto spans = [&](const BoundingBox& box) {
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
  BoundingBox at;
  at.include(p);
  tree_.visit([&](const BoundingBox& box) { return box.meets(at); },
              [&](Index segment) {
                const Ends line = ends(segment);
                if (exactly::orientation(line.left, line.right, p) == 0) found = segment;
              });
  return found;
}

}  // namespace pardel::checker
