#include "crossed_triangles.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "../../core/support/exchange_lists.hpp"
#include "../construction/crossed_edges.hpp"
#include "../given_points/problems_of_points.hpp"
#include "../triangulation/triangle_shape.hpp"

namespace pardel::engine {
namespace {

/// A point inside a segment.
struct PointInside {
  std::uint64_t point;  ///< its number in the input
  Point at;
  Index segment;
  Index unused = 0;
};

/// What a rank knows for certain about the way of segments: the triangles with an own corner, and its own points.
class Surveyor {
 public:
  Surveyor(LocalDelaunay& delaunay, const OwnPoints& own, const Threads& threads)
      : delaunay_(delaunay), t_(delaunay.triangulation()), own_(own), ask_(threads.stop) {}

  void follow(Constraint c, Index segment) {
    find_crossed_edges(t_, c, delaunay_.triangle_at(c.a), ask_, crossed_);
    if (!crossed_.present.none()) add_both(crossed_.present);
    for (const EdgeRef e : crossed_.edges) add_both(e);
    if (const VertexId v = crossed_.passed; v != no_index && delaunay_.is_own(v))
      inside_.push_back({own_.number[v], t_.points[v], segment});
  }

  /// The corners of the triangles at home here.
  [[nodiscard]] const std::vector<Site>& corners() const { return corners_; }
  [[nodiscard]] const std::vector<PointInside>& points_inside() const { return inside_; }

 private:
  void add_both(EdgeRef e) {
    add(e.triangle());
    add(t_.slot(e).n[e.side()].triangle());
  }
  void add(TriangleId id) {
    const Slot& slot = t_.slots[id];
    if (slot.is_ghost() || !delaunay_.is_own(least_corner(t_, slot))) return;
    for (const VertexId v : slot.v) corners_.push_back(delaunay_.site(v));
  }

  LocalDelaunay& delaunay_;
  const Triangulation& t_;
  const OwnPoints& own_;
  SparseAsk ask_;
  CrossedEdges crossed_;
  std::vector<Site> corners_;
  std::vector<PointInside> inside_;
};

std::vector<Problem> problems_of(std::vector<PointInside> all) {
  std::ranges::sort(all, [](const PointInside& a, const PointInside& b) {
    return std::pair(a.point, a.segment) < std::pair(b.point, b.segment);
  });
  std::vector<Problem> problems;
  for (const PointInside& each : all)
    problems.push_back({ProblemKind::point_on_segment, {id_of_problem(each.point), each.segment}, each.at});
  return problems;
}

}  // namespace

OrderedConstraints ordered_constraints(const CommonVertices& common, LocalDelaunay& delaunay) {
  const std::vector<Segment>& segments = common.segments();
  OrderedConstraints ordered;
  for (Index s = 0; s < segments.size(); ++s) ordered.segment.push_back(s);
  std::ranges::sort(ordered.segment, {}, [&](Index s) { return std::minmax(segments[s].a, segments[s].b); });
  std::vector<VertexId> vertex(common.size(), no_index);
  for (const Index s : ordered.segment) {
    const auto [a, b] = std::minmax(segments[s].a, segments[s].b);
    for (const Index end : {a, b}) vertex[end] = delaunay.vertex({common[end].at, common[end].position});
    ordered.edges.push_back({vertex[a], vertex[b]});
  }
  return ordered;
}

std::vector<Problem> learn_crossed_triangles(const OrderedConstraints& constraints, LocalDelaunay& delaunay,
                                             const OwnPoints& own, Ranks& ranks, const Threads& threads) {
  if (constraints.edges.empty()) return {};
  Surveyor surveyor(delaunay, own, threads);
  for (std::size_t i = 0; i < constraints.edges.size(); ++i)
    surveyor.follow(constraints.edges[i], constraints.segment[i]);
  const auto inside = concatenated(lists_of_all(surveyor.points_inside(), ranks));
  if (!inside.empty()) return problems_of(inside);
  std::vector<Site> here = surveyor.corners();
  sort_by_position(here);
  std::vector<Site> all = concatenated(lists_of_all(here, ranks));
  sort_by_position(all);
  for (const Site& site : all) static_cast<void>(delaunay.vertex(site));
  return {};
}

}  // namespace pardel::engine
