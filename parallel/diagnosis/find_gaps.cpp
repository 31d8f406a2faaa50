// Two points that are close to each other, and see each other, are the ends of an edge of the triangulation. A point
// that is close to a segment, and sees it, is the corner of a flat triangle; between this triangle and the segment
// there are at most other flat triangles. So only triangles with a small height need to be examined.
#include "find_gaps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>

#include "../arithmetic/distance.hpp"
#include "../arithmetic/predicates.hpp"
#include "../concurrency/bounding_box.hpp"
#include "../concurrency/parallel_arrays.hpp"
#include "../triangulation/triangle_shape.hpp"
#include "straight_walk.hpp"

namespace pardel::engine {
namespace {

/// What is narrow in a domain.
struct Narrow {
  double always;      ///< narrower than this
  double relatively;  ///< narrower than this, and than a thousandth of the surroundings
};

Narrow narrow_in(const Array<Point>& points, const Threads& threads) {
  const Box box = bounding_box(threads, points.size(), [&](std::size_t i) { return points[i]; });
  const double always = 0x1p-32 * box.largest_magnitude();
  return {always, std::max(always, 1e-6 * box.extent())};
}

/// So many edges of a vertex are enough for a median. A vertex may have any number of them.
constexpr std::size_t most_edges = 64;

class GapSearch {
 public:
  GapSearch(const DomainTriangulation& domain, Narrow narrow)
      : domain_(domain), t_(domain.triangulation), narrow_(narrow) {
    longest_.resize(t_.points.size());
    for (Index s = 0; s < domain.segments.size(); ++s) {
      const DomainSegment& segment = domain.segments[s];
      const double length = distance(segment.a, segment.b);
      for (const VertexId end : {segment.a, segment.b}) longest_[end] = std::max(longest_[end], length);
    }
  }

  /// Examines a flat triangle.
  void examine(TriangleId id) {
    const Slot& slot = t_.slots[id];
    const Shape shape(t_, slot);
    const unsigned shortest = shape.shortest_side();
    const double length = std::sqrt(shape.shortest_squared());
    const double height = shape.twice_area / std::sqrt(shape.longest_squared());
    if (length < narrow_.relatively) add_pair(EdgeRef(id, shortest));
    if (length > 2 * height) find_segment_below(id, shape);
  }

  /// The gaps, narrowest first, without those whose first point is in a narrower one.
  std::vector<Gap> gaps() && {
    std::ranges::sort(gaps_, [](const Gap& g, const Gap& h) {
      return std::tie(g.distance, g.points, g.kind, g.segment) < std::tie(h.distance, h.points, h.kind, h.segment);
    });
    std::vector<bool> is_named(t_.points.size());
    std::vector<Gap> chosen;
    for (Gap& gap : gaps_) {
      if (is_named[gap.points[0]]) continue;
      is_named[gap.points[0]] = true;
      if (gap.kind == GapKind::close_points || gap.kind == GapKind::short_segment) {
        if (is_named[gap.points[1]]) continue;
        is_named[gap.points[1]] = true;
      }
      chosen.push_back(std::move(gap));
    }
    return chosen;
  }

 private:
  [[nodiscard]] double distance(VertexId u, VertexId v) const { return engine::distance(t_.points[u], t_.points[v]); }
  /// The longest segment at a vertex; infinity for an isolated vertex.
  [[nodiscard]] double longest_at(VertexId v) const { return longest_[v] > 0 ? longest_[v] : INFINITY; }
  /// The longest segment at a corner of the triangle. For an isolated vertex the median length of its edges: where
  /// points are dense, all distances are small, and none of them is a gap.
  [[nodiscard]] double surroundings_at(TriangleId id, VertexId v) const {
    if (longest_[v] > 0) return longest_[v];
    std::array<double, most_edges> lengths;
    std::size_t count = 0;
    for (const auto* turn : {&next_corner, &previous_corner}) {
      TriangleId at = id;
      do {
        const Slot& slot = t_.slots[at];
        const unsigned across = (*turn)[slot.corner_of(v)];
        lengths[count++] = distance(v, slot.v[3 - across - slot.corner_of(v)]);
        const EdgeRef beyond = slot.n[across];
        if (beyond.none()) break;  // the boundary of the domain: the other edges lie in the other direction
        at = beyond.triangle();
      } while (at != id && count < most_edges);
      if (at == id || count == most_edges) break;
    }
    const std::span all(lengths.data(), count);
    std::ranges::nth_element(all, all.begin() + static_cast<std::ptrdiff_t>(count / 2));
    return all[count / 2];
  }
  [[nodiscard]] Index input(VertexId v) const { return domain_.input_of_vertex[v]; }

  /// Nobody drew the sides of the convex hull. Among many random points some are near them, which means nothing.
  void add(GapKind kind, std::vector<Index> points, Index segment, double wide, double surroundings, Point where) {
    const bool is_drawn = kind != GapKind::point_near_hull;
    if (wide < narrow_.always || (is_drawn && wide < narrow_.relatively && much_narrower * wide < surroundings))
      gaps_.push_back({kind, std::move(points), segment, wide, surroundings, where});
  }

  void add_pair(EdgeRef e) {
    const Slot& slot = t_.slot(e);
    VertexId u = slot.from(e.side()), v = slot.to(e.side());
    if (input(v) < input(u)) std::swap(u, v);
    Index segment = no_index;
    if (slot.n[e.side()].constrained()) segment = domain_.input_segment[domain_.segments.segment_of(t_, u, v)];
    const double wide = distance(u, v);
    double surroundings = surroundings_at(e.triangle(), u);
    // Mostly, the surroundings of u are already small enough.
    if (wide < narrow_.always || much_narrower * wide < surroundings)
      surroundings = std::min(surroundings, surroundings_at(e.triangle(), v));
    add(segment == no_index ? GapKind::close_points : GapKind::short_segment, {input(u), input(v)}, segment, wide,
        surroundings, t_.points[u]);
  }

  /// Walks from a corner of a flat triangle straight across the longest side, to a segment if there is one.
  void find_segment_below(TriangleId id, const Shape& shape) {
    const auto largest = static_cast<unsigned>(std::ranges::max_element(shape.squared) - shape.squared.begin());
    const StraightWalk walk(t_, shape.p[largest], shape.p[next_corner[largest]], shape.p[previous_corner[largest]]);
    const EdgeRef e = walk.to_constraint(EdgeRef(id, largest));
    if (!e.none()) add_beside(t_.slots[id].v[largest], e);
  }

  void add_beside(VertexId top, EdgeRef e) {
    const Slot& slot = t_.slot(e);
    const Index s = domain_.segments.segment_of(t_, slot.from(e.side()), slot.to(e.side()));
    const DomainSegment& segment = domain_.segments[s];
    const Point p = t_.points[top];
    const double length = distance(segment.a, segment.b);
    const double wide = std::abs(orient2d(t_.points[segment.a], t_.points[segment.b], p)) / length;
    const double surroundings = std::min(length, longest_at(top));
    if (const Index of_input = domain_.input_segment[s]; of_input != no_index)
      add(GapKind::point_near_segment, {input(top)}, of_input, wide, surroundings, p);
    else
      add(GapKind::point_near_hull, {input(top), input(segment.a), input(segment.b)}, no_index, wide, surroundings, p);
  }

  const DomainTriangulation& domain_;
  const Triangulation& t_;
  Narrow narrow_;
  std::vector<double> longest_;  ///< of the segments at each vertex
  std::vector<Gap> gaps_;
};

}  // namespace

std::vector<Gap> find_gaps(const DomainTriangulation& domain, const Threads& threads) {
  const Triangulation& t = domain.triangulation;
  const Narrow narrow = narrow_in(t.points, threads);
  const double squared = narrow.relatively * narrow.relatively;
  const Array<Index> flat = indices_where(threads, t.slots.size(), [&](std::size_t id) {
    const Shape shape(t, t.slots[id]);
    return shape.twice_area * shape.twice_area < squared * shape.longest_squared();
  });
  if (flat.empty()) return {};
  GapSearch search(domain, narrow);
  SparseAsk ask(threads.stop);
  for (const TriangleId id : flat) {
    ask();
    search.examine(id);
  }
  return std::move(search).gaps();
}

}  // namespace pardel::engine
