#include "common_segments.hpp"

#include <algorithm>
#include <utility>

#include "../../core/support/collective.hpp"
#include "../../core/support/exchange_lists.hpp"
#include "../../parallel/construction/crossed_edges.hpp"
#include "../../parallel/triangulation/triangle_shape.hpp"
#include "sides_of_triangles.hpp"

namespace pardel::engine {
namespace {

/// Removes the segments that satisfy the predicate, and returns them.
template <class IsWanted>
std::vector<GivenSegment> taken_from(std::vector<GivenSegment>& segments, const IsWanted& is_wanted) {
  std::vector<GivenSegment> taken;
  std::erase_if(segments, [&](const GivenSegment& s) {
    if (!is_wanted(s)) return false;
    taken.push_back(s);
    return true;
  });
  return taken;
}

/// What a rank knows for certain about the way of segments: the triangles with an own corner.
class Surveyor {
 public:
  Surveyor(LocalDelaunay& delaunay, const Threads& threads)
      : delaunay_(delaunay), t_(delaunay.triangulation()), ask_(threads.stop) {}

  void follow(const GivenSegment& segment) {
    const Constraint c{delaunay_.vertex(segment.a), delaunay_.vertex(segment.b)};
    find_crossed_edges(t_, c, delaunay_.triangle_at(c.a), ask_, crossed_);
    for (const EdgeRef e : crossed_.edges)
      for (const TriangleId id : {e.triangle(), t_.slot(e).n[e.side()].triangle()}) add_crossed(id);
    if (crossed_.passed != no_index && delaunay_.is_own(crossed_.passed)) ++points_inside_;
  }

  /// Adds the triangles on both sides of an edge at a point of this rank.
  void add_beside(EdgeRef e) {
    for (const TriangleId id : {e.triangle(), t_.slot(e).n[e.side()].triangle()}) add_corners(id);
  }

  /// The corners of the crossed triangles at home here, and of those that were added.
  [[nodiscard]] const std::vector<Site>& corners() const { return corners_; }
  /// The sides that begin at a point of this rank, along the curve. Sorted.
  [[nodiscard]] std::vector<PositionsOfEnds> take_sides() {
    std::ranges::sort(sides_);
    return std::move(sides_);
  }
  [[nodiscard]] std::uint64_t points_inside() const { return points_inside_; }

 private:
  void add_crossed(TriangleId id) {
    const Slot& slot = t_.slots[id];
    if (slot.is_ghost()) return;
    for (unsigned side = 0; side < 3; ++side) {
      const Site from = delaunay_.site(slot.from(side)), to = delaunay_.site(slot.to(side));
      if (delaunay_.is_own(from.position < to.position ? slot.from(side) : slot.to(side)))
        sides_.push_back(std::minmax(from.position, to.position));
    }
    if (delaunay_.is_own(least_corner(t_, slot))) add_corners(id);
  }
  void add_corners(TriangleId id) {
    for (const VertexId v : t_.slots[id].v)
      if (v != ghost) corners_.push_back(delaunay_.site(v));
  }

  LocalDelaunay& delaunay_;
  const Triangulation& t_;
  SparseAsk ask_;
  CrossedEdges crossed_;
  std::vector<Site> corners_;
  std::vector<PositionsOfEnds> sides_;
  std::uint64_t points_inside_ = 0;
};

}  // namespace

DividedSegments divide_segments(std::vector<GivenSegment>&& own_segments, const SharedHull& hull,
                                LocalDelaunay& delaunay, const OwnPoints& own, Ranks& ranks, const Threads& threads) {
  DividedSegments divided;
  divided.own = std::move(own_segments);
  const auto begins_here = [&](const GivenSegment& s) { return own.owner(s.a.position) == ranks.rank(); };
  const auto take = [&](const auto& is_common) {
    return taken_from(divided.own, [&](const GivenSegment& s) { return begins_here(s) && is_common(s); });
  };
  divided.common = concatenated(
      lists_of_all(take([&](const GivenSegment& s) { return side_between(delaunay, s.a, s.b).none(); }), ranks));
  sort_by_ends(divided.common);
  Surveyor surveyor(delaunay, threads);
  for (const GivenSegment& segment : divided.common) surveyor.follow(segment);
  divided.pass_points = sum_of(surveyor.points_inside(), ranks) > 0;
  if (divided.pass_points) return divided;

  const std::vector<PositionsOfEnds> crossed_sides = surveyor.take_sides();
  const std::vector<GivenSegment> edges = take([&](const GivenSegment& s) {
    return std::ranges::binary_search(crossed_sides, ends_of(s)) || hull.has_edge(s.a.position, s.b.position) ||
           hull.has_edge(s.b.position, s.a.position);
  });
  for (const GivenSegment& s : edges) surveyor.add_beside(side_between(delaunay, s.a, s.b));
  const std::vector<GivenSegment> all_edges = concatenated(lists_of_all(edges, ranks));
  divided.common.insert(divided.common.end(), all_edges.begin(), all_edges.end());
  sort_by_ends(divided.common);
  std::erase_if(divided.own, [&](const GivenSegment& s) {
    return !begins_here(s) && with_ends(divided.common, ends_of(s)) != nullptr;
  });

  std::vector<Site> here = surveyor.corners();
  sort_by_position(here);
  std::vector<Site> corners = concatenated(lists_of_all(here, ranks));
  sort_by_position(corners);
  for (const Site& site : corners) static_cast<void>(delaunay.vertex(site));
  return divided;
}

}  // namespace pardel::engine
