// Two points that are close to each other, and see each other, are the ends of an edge of the triangulation. A point
// that is close to a segment, and sees it, is the corner of a flat triangle; between this triangle and the segment
// there are at most other flat triangles. So only triangles with a small height need to be examined.
#include "find_gaps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <tuple>
#include <utility>

#include "../arithmetic/distance.hpp"
#include "../arithmetic/predicates.hpp"
#include "../decomposition/bounding_box.hpp"
#include "../threads/parallel_arrays.hpp"
#include "../triangulation/triangle_shape.hpp"
#include "extents_by_scale.hpp"
#include "straight_walk.hpp"

namespace pardel::engine {
namespace {

/// Compared with the extent.
constexpr double relatively_narrow = 1e-6;

/// What is narrow in a domain.
struct Narrow {
  double relatively;  ///< a gap is narrow if it is narrower than this and than a thousandth of its surroundings
  double most;        ///< no gap that is wider than this is narrow

  /// At this place, a gap that is narrower than this is narrow, whatever surrounds it.
  [[nodiscard]] static double always(Point p) { return 0x1p-32 * std::max(std::abs(p.x), std::abs(p.y)); }
};

Narrow narrow_in(const Array<Point>& points, const Threads& threads) {
  const Box box = bounding_box(threads, points.size(), [&](std::size_t i) { return points[i]; });
  const double relatively = relatively_narrow * box.extent();
  return {relatively, std::max(relatively, 0x1p-32 * box.largest_magnitude())};
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

  /// The gaps at a flat triangle are appended to `found`.
  void examine(TriangleId id, std::vector<Gap>& found) const {
    const Slot& slot = t_.slots[id];
    const Shape shape(t_, slot);
    const unsigned shortest = shape.shortest_side();
    const double length = std::sqrt(shape.shortest_squared());
    const double height = shape.twice_area / std::sqrt(shape.longest_squared());
    if (length < narrow_.most) add_pair(EdgeRef(id, shortest), found);
    if (length > 2 * height) find_segment_below(id, shape, found);
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
  void add(Gap gap, std::vector<Gap>& found) const {
    const bool is_drawn = gap.kind != GapKind::point_near_hull;
    if (gap.distance < Narrow::always(gap.where) ||
        (is_drawn && gap.distance < narrow_.relatively && much_narrower * gap.distance < gap.surroundings))
      found.push_back(std::move(gap));
  }

  void add_pair(EdgeRef e, std::vector<Gap>& found) const {
    const Slot& slot = t_.slot(e);
    VertexId u = slot.from(e.side()), v = slot.to(e.side());
    if (input(v) < input(u)) std::swap(u, v);
    Index segment = no_index;
    if (slot.n[e.side()].constrained()) segment = domain_.input_segment[domain_.segments.segment_of(t_, u, v)];
    const double wide = distance(u, v);
    double surroundings = surroundings_at(e.triangle(), u);
    // Mostly, the surroundings of u are already small enough.
    if (wide < Narrow::always(t_.points[u]) || much_narrower * wide < surroundings)
      surroundings = std::min(surroundings, surroundings_at(e.triangle(), v));
    const GapKind kind = segment == no_index ? GapKind::close_points : GapKind::short_segment;
    add({kind, {input(u), input(v)}, segment, wide, surroundings, t_.points[u]}, found);
  }

  /// Walks from a corner of a flat triangle straight across the longest side, to a segment if there is one.
  void find_segment_below(TriangleId id, const Shape& shape, std::vector<Gap>& found) const {
    const auto largest = static_cast<unsigned>(std::ranges::max_element(shape.squared) - shape.squared.begin());
    const StraightWalk walk(t_, shape.p[largest], shape.p[next_corner[largest]], shape.p[previous_corner[largest]]);
    const EdgeRef e = walk.to_constraint(EdgeRef(id, largest));
    if (!e.none()) add_beside(t_.slots[id].v[largest], e, found);
  }

  void add_beside(VertexId top, EdgeRef e, std::vector<Gap>& found) const {
    const Slot& slot = t_.slot(e);
    const Index s = domain_.segments.segment_of(t_, slot.from(e.side()), slot.to(e.side()));
    const DomainSegment& segment = domain_.segments[s];
    const Point p = t_.points[top];
    const double length = distance(segment.a, segment.b);
    const double wide = std::abs(orient2d(t_.points[segment.a], t_.points[segment.b], p)) / length;
    const double surroundings = std::min(length, longest_at(top));
    if (const Index of_input = domain_.input_segment[s]; of_input != no_index)
      add({GapKind::point_near_segment, {input(top)}, of_input, wide, surroundings, p}, found);
    else
      add({GapKind::point_near_hull, {input(top), input(segment.a), input(segment.b)}, no_index, wide, surroundings, p},
          found);
  }

  const DomainTriangulation& domain_;
  const Triangulation& t_;
  Narrow narrow_;
  std::vector<double> longest_;  ///< of the segments at each vertex
};

/// The extent of what has about the scale of a gap. Far points and large parts elsewhere do not count.
class Neighbourhoods {
 public:
  explicit Neighbourhoods(const DomainTriangulation& domain)
      : of_point_(domain.triangulation.points.size()), of_segment_(domain.segments.size()) {
    const Triangulation& t = domain.triangulation;
    for (Index s = 0; s < domain.segments.size(); ++s) {
      if (domain.input_segment[s] == no_index) continue;
      const DomainSegment& segment = domain.segments[s];
      const Box box = Box::around(t.points[segment.a], t.points[segment.b]);
      extents_.add(box);
      of_segment_[s] = {domain.input_segment[s], box.largest_magnitude()};
      for (const VertexId end : {segment.a, segment.b}) {
        double& scale = of_point_[domain.input_of_vertex[end]];
        scale = std::max(scale, box.largest_magnitude());
      }
    }
    std::ranges::sort(of_segment_);
    if (extents_.empty())
      for (const Point p : t.points) extents_.add(Box::around(p));
  }

  [[nodiscard]] double extent_around(const Gap& gap) const {
    double scale = scale_of_point(gap.points[0], gap.where);
    if (gap.kind == GapKind::point_near_segment)
      scale = std::min(scale, std::ranges::lower_bound(of_segment_, std::pair(gap.segment, 0.0))->second);
    else
      scale = std::min(scale, scale_of_point(gap.points[1], gap.where));
    return extents_.near(scale);
  }

 private:
  [[nodiscard]] double scale_of_point(Index point, Point near) const {
    return of_point_[point] > 0 ? of_point_[point] : extents_.next_scale(Box::around(near).largest_magnitude());
  }

  ExtentsByScale extents_;                            ///< of the segments; without segments, of the points
  std::vector<double> of_point_;                      ///< the largest scale of the segments at each input point
  std::vector<std::pair<Index, double>> of_segment_;  ///< input segments and their scales
};

void remove_locally_wide(std::vector<Gap>& gaps, const DomainTriangulation& domain) {
  const auto depends_on_extent = [](const Gap& gap) { return !(gap.distance < Narrow::always(gap.where)); };
  if (std::ranges::none_of(gaps, depends_on_extent)) return;
  const Neighbourhoods around(domain);
  std::erase_if(gaps, [&](const Gap& gap) {
    return depends_on_extent(gap) && gap.distance >= relatively_narrow * around.extent_around(gap);
  });
}

}  // namespace

std::vector<Gap> gaps_in_share(const DomainTriangulation& domain, Share share, const Threads& threads) {
  const Triangulation& t = domain.triangulation;
  const Narrow narrow = narrow_in(t.points, threads);
  const double squared = narrow.most * narrow.most;
  const std::size_t begin = share.begin(t.slots.size());
  const Array<Index> flat = indices_where(threads, share.end(t.slots.size()) - begin, [&](std::size_t i) {
    const Shape shape(t, t.slots[begin + i]);
    return shape.twice_area * shape.twice_area < squared * shape.longest_squared();
  });
  if (flat.empty()) return {};
  const GapSearch search(domain, narrow);
  std::vector<std::vector<Gap>> of_block(block_count(flat.size()));
  parallel_blocks(threads, flat.size(), [&](std::size_t first, std::size_t last, std::size_t block) {
    for (std::size_t i = first; i < last; ++i)
      search.examine(static_cast<TriangleId>(begin + flat[i]), of_block[block]);
  });
  std::vector<Gap> all;
  for (std::vector<Gap>& found : of_block) std::ranges::move(found, std::back_inserter(all));
  return all;
}

std::vector<Gap> narrowest_first(std::vector<Gap> gaps, const DomainTriangulation& domain) {
  remove_locally_wide(gaps, domain);
  std::ranges::sort(gaps, [](const Gap& g, const Gap& h) {
    return std::tie(g.distance, g.points, g.kind, g.segment) < std::tie(h.distance, h.points, h.kind, h.segment);
  });
  std::vector<bool> is_named(domain.triangulation.points.size());
  std::vector<Gap> chosen;
  for (Gap& gap : gaps) {
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

std::vector<Gap> find_gaps(const DomainTriangulation& domain, const Threads& threads) {
  return narrowest_first(gaps_in_share(domain, {}, threads), domain);
}

}  // namespace pardel::engine
