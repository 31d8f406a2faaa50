#include "straight_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "doubled_area.hpp"
#include "point_order.hpp"

namespace pardel {
namespace {

using Path = std::vector<Index>;

double squared_distance(Point a, Point b) { return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y); }

/// The paths of segments between points at which one segment ends, or more than two.
class Paths {
 public:
  Paths(std::span<const Point> points, std::span<const Segment> segments, SparseAsk& ask)
      : points_(points), segments_(segments), at_(points.size()), done_(segments.size(), false), ask_(ask) {
    for (Index s = 0; s < segments.size(); ++s) {
      ask_();
      const auto [a, b] = std::pair(segments[s].a, segments[s].b);
      done_[s] = a == b;
      if (a == b) continue;
      for (const Index v : {a, b}) {
        if (at_[v].count < 2) at_[v].segments[at_[v].count] = s;
        ++at_[v].count;
      }
    }
  }

  /// Calls visit(path) for each path with inner points. A closed path begins and ends at its least point, which is a
  /// corner.
  template <class Visit>
  void for_each(const Visit& visit) {
    for (Index s = 0; s < segments_.size(); ++s)
      for (const Index v : {segments_[s].a, segments_[s].b})
        if (!done_[s] && at_[v].count != 2) visit_from(v, s, visit);
    for (Index s = 0; s < segments_.size(); ++s)
      if (!done_[s]) visit_from(least_of_ring(s), no_index, visit);
  }

 private:
  struct Incident {
    Index count = 0;
    std::array<Index, 2> segments{no_index, no_index};
  };

  [[nodiscard]] Index other_end(Index s, Index v) const {
    return segments_[s].a == v ? segments_[s].b : segments_[s].a;
  }
  [[nodiscard]] Index other_segment(Index v, Index s) const {
    return at_[v].segments[0] == s ? at_[v].segments[1] : at_[v].segments[0];
  }
  [[nodiscard]] Index least_of_ring(Index s) const {
    const Index start = segments_[s].a;
    Index least = start;
    for (Index v = other_end(s, start); v != start; v = other_end(s, v)) {
      ask_();
      if (lexicographically_less(points_[v], points_[least])) least = v;
      s = other_segment(v, s);
    }
    return least;
  }
  /// Follows the path that leaves `start` along the segment s, or a ring in any direction if s is no_index.
  template <class Visit>
  void visit_from(Index start, Index s, const Visit& visit) {
    if (s == no_index) s = at_[start].segments[0];
    Path path{start};
    for (;;) {
      ask_();
      done_[s] = true;
      path.push_back(other_end(s, path.back()));
      if (path.back() == start || at_[path.back()].count != 2) break;
      s = other_segment(path.back(), s);
    }
    const bool backwards =
        lexicographically_less(points_[path.back()], points_[path.front()]) ||
        (path.front() == path.back() && lexicographically_less(points_[path[path.size() - 2]], points_[path[1]]));
    if (backwards) std::ranges::reverse(path);
    if (path.size() > 2) visit(std::as_const(path));
  }

  std::span<const Point> points_;
  std::span<const Segment> segments_;
  std::vector<Incident> at_;
  std::vector<bool> done_;
  SparseAsk& ask_;
};

class Division {
 public:
  Division(std::span<const Point> points, const IsStraight& is_straight, SparseAsk& ask)
      : points_(points), is_straight_(is_straight), ask_(ask), straight_(points.size(), false) {}

  void divide(std::span<const Index> path) {
    const double slack = slack_of(path);
    std::size_t first = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      ask_();
      if (i + 1 < path.size() && !turns(path[i - 1], path[i], path[i + 1], slack)) continue;
      divide_smooth(path.subspan(first, i + 1 - first));
      first = i;
    }
  }
  [[nodiscard]] std::vector<bool> take() { return std::move(straight_); }

 private:
  /// More than a point of a straight path can lie off the line through the points before and after it: each of the
  /// three is off by a few units of the largest coordinate.
  [[nodiscard]] double slack_of(std::span<const Index> path) const {
    double largest = 0;
    for (const Index v : path) largest = std::max({largest, std::abs(points_[v].x), std::abs(points_[v].y)});
    return 16 * (std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest);
  }
  /// True if the path visibly turns at v. This only saves time: paths that zigzag need not be divided point by point.
  [[nodiscard]] bool turns(Index before, Index v, Index after, double slack) const {
    const Point p = points_[before], o = points_[v], q = points_[after];
    const double dot = (p.x - o.x) * (q.x - o.x) + (p.y - o.y) * (q.y - o.y);
    return !(dot < 0) || std::abs(doubled_area(p, o, q)) > slack * std::sqrt(squared_distance(p, q));
  }
  void divide_smooth(std::span<const Index> whole) {
    // Few paths are divided so often. Those that zigzag just above rounding could be divided point by point.
    constexpr int most_divisions = 50;
    struct Part {
      std::span<const Index> path;
      int divisions;
    };
    std::vector<Part> open{{whole, 0}};
    while (!open.empty()) {
      const auto [path, divisions] = open.back();
      open.pop_back();
      if (path.size() < 3) continue;
      if (path.front() != path.back() && is_straight_(path)) {
        for (const Index v : path.subspan(1, path.size() - 2)) straight_[v] = true;
        continue;
      }
      const std::size_t corner = divisions < most_divisions ? farthest(path) : path.size() / 2;
      open.push_back({path.subspan(0, corner + 1), divisions + 1});
      open.push_back({path.subspan(corner), divisions + 1});
    }
  }
  /// The inner point that is farthest from the line through the ends, or from the common end of a ring.
  [[nodiscard]] std::size_t farthest(std::span<const Index> path) const {
    const Point a = points_[path.front()], b = points_[path.back()];
    std::size_t best = 1;
    double largest = -1;
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      ask_();
      const Point p = points_[path[i]];
      const double off = path.front() == path.back() ? squared_distance(a, p) : std::abs(doubled_area(a, b, p));
      if (off > largest) {
        largest = off;
        best = i;
      }
    }
    return best;
  }

  std::span<const Point> points_;
  const IsStraight& is_straight_;
  SparseAsk& ask_;
  std::vector<bool> straight_;
};

}  // namespace

std::vector<bool> straight_points(std::span<const Point> points, std::span<const Segment> segments,
                                  const IsStraight& is_straight, StopSignal* stop) {
  SparseAsk ask(stop);
  Division division(points, is_straight, ask);
  Paths(points, segments, ask).for_each([&](const Path& path) { division.divide(path); });
  return division.take();
}

}  // namespace pardel
