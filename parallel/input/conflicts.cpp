#include "conflicts.hpp"

#include <algorithm>
#include <array>
#include <compare>

#include "../../core/support/point_order.hpp"
#include "../arithmetic/expansion.hpp"
#include "../arithmetic/predicates.hpp"

namespace pardel::engine {
namespace {

/// Precondition: a, b and p are collinear.
bool strictly_between(Point a, Point b, Point p) {
  return (lexicographically_less(a, p) && lexicographically_less(p, b)) ||
         (lexicographically_less(b, p) && lexicographically_less(p, a));
}

/// The common part of two segments on one line; empty if `end` is smaller than `begin`.
struct Stretch {
  Point begin, end;
};
Stretch common_stretch(Point a, Point b, Point c, Point d) {
  const auto less = lexicographically_less;
  return {std::max(std::min(a, b, less), std::min(c, d, less), less),
          std::min(std::max(a, b, less), std::max(c, d, less), less)};
}

/// The common point of the lines ab and cd. Precondition: they are not parallel.
Point crossing_point(Point a, Point b, Point c, Point d) {
  // a + (b - a) * area(a, c, d) / (area(a, c, d) - area(b, c, d)), with numerator and denominator rounded once.
  using exact::Expansion;
  using exact::two_difference;
  const Expansion<2> dx(two_difference(d.x, c.x)), dy(two_difference(d.y, c.y));
  const Expansion<2> ux(two_difference(b.x, a.x)), uy(two_difference(b.y, a.y));
  const Expansion<2> wx(two_difference(a.x, c.x)), wy(two_difference(a.y, c.y));
  const auto above = dx * wy - dy * wx;
  const auto below = dy * ux - dx * uy;
  return {snapped((below * a.x + above * ux).estimate() / below.estimate()),
          snapped((below * a.y + above * uy).estimate() / below.estimate())};
}

class Search {
 public:
  Search(std::span<const Point> points, std::span<const Segment> segments, std::size_t most)
      : points_(points), segments_(segments), most_(most) {}

  /// Adds the conflicts of s and t. Returns false if the search has to end.
  bool compare(Index s, Index t) {
    const auto [a, b, s_marker] = segments_[s];
    const auto [c, d, t_marker] = segments_[t];
    const int c_side = side(a, b, c), d_side = side(a, b, d);
    if (c_side * d_side > 0) return true;
    const int a_side = side(c, d, a), b_side = side(c, d, b);
    if (a_side * b_side > 0) return true;
    if (c_side * d_side < 0 && a_side * b_side < 0)
      return add({ConflictKind::crossing, std::min(s, t), std::max(s, t)});

    bool go_on = true;
    if (c_side == 0 && d_side == 0) {
      const Stretch common = common_stretch(points_[a], points_[b], points_[c], points_[d]);
      if (lexicographically_less(common.begin, common.end))
        go_on &= add({ConflictKind::overlapping, std::min(s, t), std::max(s, t)});
    }
    if (c_side == 0) go_on &= add_if_between(c, s);
    if (d_side == 0) go_on &= add_if_between(d, s);
    if (a_side == 0) go_on &= add_if_between(a, t);
    if (b_side == 0) go_on &= add_if_between(b, t);
    return go_on;
  }

  /// The same for a segment and a point that is no end of a segment.
  bool compare_point(Index p, Index s) { return side(segments_[s].a, segments_[s].b, p) != 0 || add_if_between(p, s); }

  /// Removes duplicates: an end of several segments that lies on another segment is found several times.
  std::vector<Conflict> sorted() && {
    std::ranges::sort(conflicts_);
    conflicts_.erase(std::unique(conflicts_.begin(), conflicts_.end()), conflicts_.end());
    return std::move(conflicts_);
  }

 private:
  /// The sign of orient2d(a, b, p); 0 without any arithmetic if p is a or b.
  [[nodiscard]] int side(Index a, Index b, Index p) const {
    if (p == a || p == b) return 0;
    const double det = orient2d(points_[a], points_[b], points_[p]);
    return (det > 0) - (det < 0);
  }
  /// Adds the conflict of p and s, if p is between the ends. Precondition: p is on the line of s.
  bool add_if_between(Index p, Index s) {
    const Segment& segment = segments_[s];
    return !strictly_between(points_[segment.a], points_[segment.b], points_[p]) ||
           add({ConflictKind::point_on_segment, p, s});
  }
  bool add(const Conflict& conflict) {
    conflicts_.push_back(conflict);
    return ++count_[static_cast<std::size_t>(conflict.kind)] < most_;
  }

  std::span<const Point> points_;
  std::span<const Segment> segments_;
  std::size_t most_;
  std::array<std::size_t, 3> count_{};
  std::vector<Conflict> conflicts_;
};

}  // namespace

std::vector<Conflict> find_conflicts(std::span<const Point> points, std::span<const Segment> segments,
                                     std::span<const Index> candidates, const SegmentIndex& index, std::size_t most) {
  Search search(points, segments, most);
  index.for_each_near_pair([&](Index s, Index t) { return search.compare(s, t); });
  for (const Index p : candidates) {
    const Box at = Box::around(points[p]);
    if (!index.for_each_near(at, [&](Index s) { return search.compare_point(p, s); })) break;
  }
  return std::move(search).sorted();
}

Point place_of(const Conflict& conflict, std::span<const Point> points, std::span<const Segment> segments) {
  if (conflict.kind == ConflictKind::point_on_segment) return points[conflict.first];
  const Segment &s = segments[conflict.first], &t = segments[conflict.second];
  const Point a = points[s.a], b = points[s.b], c = points[t.a], d = points[t.b];
  return conflict.kind == ConflictKind::crossing ? crossing_point(a, b, c, d) : common_stretch(a, b, c, d).begin;
}

}  // namespace pardel::engine
