// Inserts single points into triangulations of random domains, and tests the triangles that this changes and makes.
#include <algorithm>
#include <cmath>

#include "../../../parallel/construction/delaunay.hpp"
#include "../../../parallel/construction/domain_triangulation.hpp"
#include "../../../parallel/quality/small_angles.hpp"
#include "../../../parallel/refinement/insertion.hpp"
#include "../../../parallel/triangulation/locate.hpp"
#include "../../../properties/checker/arithmetic/exact.hpp"
#include "../../../properties/checker/tolerances.hpp"
#include "../../../properties/theorems/framework/property.hpp"
#include "../../../properties/theorems/framework/rapidcheck_generators.hpp"
#include "../../../properties/theorems/framework/shares.hpp"

namespace pardel::engine {
namespace {

using properties::classify;
using properties::Exhibit;

constexpr const char* families = "lattice domains of every family";
const Box everywhere;

DomainTriangulation some_triangulation(Exhibit& exhibit) {
  const Pslg pslg = generators::to_pslg(*generators::domains());
  exhibit.show(pslg);
  Result<DomainTriangulation> domain = triangulate_domain(pslg, /*convex_hull=*/false);
  RC_ASSERT(domain.ok());
  return std::move(domain).value();
}

double length(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Tries to insert the circumcentre of each triangle in turn, until one is inserted. Then calls inserted(before, n)
/// with the triangulation before the insertion and its number of triangles.
template <class Inserted>
void insert_some_circumcentre(Triangulation& t, double min_edge, const Box& box, const Inserted& inserted) {
  const Criteria criteria({}, Placement::circumcentre, {});
  const auto vertices = static_cast<Index>(t.points.size()), triangles = static_cast<Index>(t.slots.size());
  t.points.resize(vertices + 1U);
  t.origin.resize(vertices + 1U);
  t.slots.resize(triangles + 2U);
  if (!t.region.empty()) t.region.resize(triangles + 2U);
  Insertion insertion(t, criteria, min_edge);
  FreeIndices free{IndexPool({{vertices, vertices + 1}}), IndexPool({{triangles, triangles + 2}})};
  insertion.start(free);
  const Triangulation before = t;
  for (TriangleId id = 0; id < triangles; ++id) {
    const auto& v = t.slots[id].v;
    if (!std::all_of(v.begin(), v.end(), [&](VertexId c) { return box.contains_half_open(t.points[c]); })) continue;
    if (insertion.insert_in_face(criteria.split_point(Shape(t, t.slots[id]), no_index), id, box) != Outcome::inserted)
      continue;
    RC_TAG(std::string("inserted"));
    inserted(before, triangles);
    return;
  }
}

PARDEL_PROPERTY(EngineInsertion, changes_only_triangles_with_all_corners_in_its_box,
                {.statement = "an insertion replaces only triangles whose three corners lie in its box, and links to "
                              "new neighbours only triangles with two corners there",
                 .source = "properties/THEORY.md, T-region",
                 .families = families}) {
  DomainTriangulation domain = some_triangulation(exhibit);
  Triangulation& t = domain.triangulation;
  const auto some_vertex = [&] { return t.points[*rc::gen::inRange<std::size_t>(0, t.points.size())]; };
  const Point p = some_vertex(), q = some_vertex();
  const Box box{std::min(p.x, q.x), std::min(p.y, q.y), std::max(p.x, q.x), std::max(p.y, q.y)};
  insert_some_circumcentre(t, 0, box, [&](const Triangulation& before, TriangleId triangles) {
    for (TriangleId id = 0; id < triangles; ++id) {
      const auto& v = before.slots[id].v;
      const auto inside =
          std::count_if(v.begin(), v.end(), [&](VertexId c) { return box.contains_half_open(t.points[c]); });
      RC_ASSERT(t.slots[id].v == v || inside == 3);
      RC_ASSERT(t.slots[id].n == before.slots[id].n || inside >= 2);
    }
  });
}

PARDEL_PROPERTY(EngineInsertion, makes_no_edge_shorter_than_the_floor,
                {.statement = "no edge that an insertion makes is shorter than the floor",
                 .source = "properties/THEORY.md, refinement: the floor",
                 .families = families}) {
  DomainTriangulation domain = some_triangulation(exhibit);
  Triangulation& t = domain.triangulation;
  const auto& v = t.slots[*rc::gen::inRange<std::size_t>(0, t.slots.size())].v;
  const double floor = length(t.points[v[0]], t.points[v[1]]) * 0.01 * *rc::gen::inRange(10, 200);
  insert_some_circumcentre(t, floor, everywhere, [&](const Triangulation& before, TriangleId /*triangles*/) {
    const auto fresh = static_cast<VertexId>(before.points.size() - 1);
    for (const Slot& slot : t.slots)
      for (unsigned side = 0; side < 3; ++side)
        if (slot.from(side) == fresh)
          RC_ASSERT(length(t.points[fresh], t.points[slot.to(side)]) >= floor * (1 - 1e-12));
  });
}

PARDEL_PROPERTY(SplitPoint, of_a_segment_stays_within_rounding_of_it,
                {.statement = "however often the pieces of a segment are split, the points lie on it to within the "
                              "rounding of coordinates: 2 units of the segment",
                 .source = "parallel/quality/small_angles.hpp",
                 .families = "segments in all directions, near and far, with other segments at their ends"}) {
  const auto coordinate = [] { return 1e-3 * *rc::gen::inRange(-1000000, 1000000) + *rc::gen::element(0., 654321.1); };
  Triangulation t;
  t.points.push_back({coordinate(), coordinate()});
  t.points.push_back({coordinate(), coordinate()});
  const Point a = t.points[0], b = t.points[1];
  RC_PRE(length(a, b) > 1);
  const auto [x, y] = checker::units_of_segment(a, b);
  std::vector<Constraint> constraints{{0, 1}};
  for (const VertexId end : {0U, 1U}) {
    if (*rc::gen::inRange(0, 4) == 0) continue;  // no other segment
    const double cosine = *rc::gen::element(0.3, 0.6, 0.9, 1 - 0x1p-40), sine = std::sqrt(1 - cosine * cosine);
    const double scale = *rc::gen::element(0.37, 0.8, 1.5);
    const Point o = t.points[end], far = t.points[1 - end];
    const double dx = scale * (far.x - o.x), dy = scale * (far.y - o.y);
    constraints.push_back({end, static_cast<VertexId>(t.points.size())});
    t.points.push_back({o.x + cosine * dx - sine * dy, o.y + sine * dx + cosine * dy});
  }
  const DomainSegments segments(t.points, constraints);
  VertexId from = 0, to = 1;
  for (int i = 0; i < 20; ++i) {
    const auto middle = static_cast<VertexId>(t.points.size());
    t.points.push_back(edge_split_point(t, segments, 0, from, to));
    RC_ASSERT(!checker::exactly::line_offset_exceeds(t.points[middle], a, b, {chain_units * x, chain_units * y}));
    (*rc::gen::arbitrary<bool>() ? from : to) = middle;
  }
}

/// Provides indices for one insertion, attempts it, and removes the indices that it did not use.
template <class Attempt>
Outcome with_room(Triangulation& t, Insertion& insertion, const Attempt& attempt) {
  const auto vertices = static_cast<Index>(t.points.size()), triangles = static_cast<Index>(t.slots.size());
  t.points.resize(vertices + 1U);
  t.origin.resize(vertices + 1U);
  t.slots.resize(triangles + 2U);
  FreeIndices free{IndexPool({{vertices, vertices + 1}}), IndexPool({{triangles, triangles + 2}})};
  insertion.start(free);
  const Outcome outcome = attempt();
  t.points.resize(vertices + 1U - free.vertices.left());
  t.origin.resize(vertices + 1U - free.vertices.left());
  t.slots.resize(triangles + 2U - free.triangles.left());
  return outcome;
}

/// True if the triangulation is positively oriented and constrained Delaunay, by the exact arithmetic of the checker.
bool is_valid(const Triangulation& t) {
  const auto point = [&](VertexId v) { return t.points[v]; };
  for (const Slot& slot : t.slots) {
    if (checker::exactly::orientation(point(slot.v[0]), point(slot.v[1]), point(slot.v[2])) <= 0) return false;
    for (const EdgeRef across : slot.n)
      if (!across.constrained() && checker::exactly::in_circle(point(slot.v[0]), point(slot.v[1]), point(slot.v[2]),
                                                               point(t.slot(across).apex(across.side()))) > 0)
        return false;
  }
  return true;
}

DomainTriangulation hull_of(const std::vector<Point>& points, Segment segment, Exhibit& exhibit) {
  Pslg pslg;
  pslg.points = points;
  pslg.segments = {segment};
  exhibit.show(pslg);
  Result<DomainTriangulation> domain = triangulate_domain(pslg, /*convex_hull=*/true);
  RC_PRE(domain.ok());
  return std::move(domain).value();
}

double some_number(double low, double high) { return low + (high - low) * 1e-6 * *rc::gen::inRange(0, 1000001); }

/// The edge from a to b, as a side of the triangle on its left; none() if the triangulation has no such edge.
EdgeRef edge_between(const Triangulation& t, VertexId a, VertexId b) {
  for (TriangleId id = 0; id < t.slots.size(); ++id)
    for (unsigned side = 0; side < 3; ++side)
      if (t.slots[id].from(side) == a && t.slots[id].to(side) == b) return {id, side};
  return {};
}

/// True if every two consecutive vertices of the chain are the ends of an edge with a triangle on each side, and both
/// triangles know that the edge is constrained.
bool has_walls(const Triangulation& t, const std::vector<VertexId>& chain) {
  for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
    const EdgeRef left = edge_between(t, chain[k], chain[k + 1]), right = edge_between(t, chain[k + 1], chain[k]);
    if (left.none() || right.none()) return false;
    if (t.slot(left).n[left.side()] != right.with_constraint(true)) return false;
    if (t.slot(right).n[right.side()] != left.with_constraint(true)) return false;
  }
  return true;
}

/// The disks of the triangles next to such a segment reach through it and around its ends.
PARDEL_PROPERTY(EngineInsertion, next_to_a_segment_that_is_not_delaunay_leaves_a_valid_triangulation,
                {.statement = "points inserted next to a segment with vertices in its diametral circle on both sides, "
                              "and midpoints that split its pieces, leave the triangulation positively oriented and "
                              "constrained Delaunay; the pieces of the segment remain constrained edges",
                 .source = "parallel/refinement/insertion.hpp",
                 .families = "a free segment in a square, six points close to it"}) {
  std::vector<Point> points{{-8, -8}, {8, -8}, {8, 8}, {-8, 8}, {-1, 0}, {1, 0}};
  for (int i = 0; i < 6; ++i)
    points.push_back({some_number(-0.9, 0.9), some_number(0.15, 0.6) * (i % 2 == 0 ? 1 : -1)});
  DomainTriangulation domain = hull_of(points, {4, 5, 0}, exhibit);
  Triangulation& t = domain.triangulation;
  const Criteria criteria({}, Placement::circumcentre, {});
  Insertion insertion(t, criteria, 0);
  std::vector<VertexId> chain{domain.segments[0].a, domain.segments[0].b};  // the vertices on the segment, in order
  RC_ASSERT(has_walls(t, chain));
  for (int i = 0; i < 10; ++i) {
    const std::size_t piece = *rc::gen::inRange<std::size_t>(0, 4 * chain.size());
    if (piece + 1 < chain.size()) {
      const VertexId a = chain[piece], b = chain[piece + 1];
      const Point middle{(t.points[a].x + t.points[b].x) / 2, 0};
      const auto split = [&] { return insertion.split_edge(middle, edge_between(t, a, b), 0, everywhere); };
      RC_ASSERT(with_room(t, insertion, split) == Outcome::inserted);
      chain.insert(chain.begin() + static_cast<std::ptrdiff_t>(piece) + 1, static_cast<VertexId>(t.points.size() - 1));
    } else {
      const Point p{some_number(-1.6, 1.6), some_number(-0.8, 0.8)};
      with_room(t, insertion, [&] { return insertion.insert_in_face(p, locate(t, p, 0), everywhere); });
    }
    RC_ASSERT(is_valid(t));
    RC_ASSERT(has_walls(t, chain));
  }
  classify(chain.size() > 2, "the segment is split", 50);
}

/// A corner far away sees a piece of a slanted segment at an angle that is smaller than the bend caused by rounding.
PARDEL_PROPERTY(
    EngineInsertion, splitting_a_segment_far_from_the_origin_leaves_a_valid_triangulation,
    {.statement = "splitting a segment at points that rounding moved off it leaves the triangulation "
                  "positively oriented and constrained Delaunay, and the insertion tells whether it needed flips",
     .source = "parallel/refinement/insertion.hpp",
     .families = "a slanted segment and four points, one of them almost on it or not, far from the origin"}) {
  std::vector<Point> points;
  for (int i = 0; i < 6; ++i) points.push_back({some_number(654320, 654321), some_number(4987654, 4987655)});
  // Not at the middle: the floor would refuse a split there.
  const double share = *rc::gen::element(0.3, 1.0 / 3, 0.4, 0.6, 0.7);
  const Point near{points[0].x + share * (points[1].x - points[0].x),
                   points[0].y + share * (points[1].y - points[0].y)};
  if (*rc::gen::arbitrary<bool>()) points[5] = {near.x, std::nextafter(near.y, INFINITY)};
  DomainTriangulation domain = hull_of(points, {0, 1, 0}, exhibit);
  Triangulation& t = domain.triangulation;
  const Criteria criteria({}, Placement::circumcentre, {});
  Insertion insertion(t, criteria, 0);
  VertexId a = domain.segments[0].a, b = domain.segments[0].b;
  for (int i = 0; i < 16; ++i) {
    const EdgeRef e = edge_between(t, a, b);
    if (e.none()) std::swap(a, b);
    if (e.none()) continue;
    const Point p{(t.points[a].x + t.points[b].x) / 2, (t.points[a].y + t.points[b].y) / 2};
    if (with_room(t, insertion, [&] { return insertion.split_edge(p, e, 0, everywhere); }) != Outcome::inserted) return;
    RC_ASSERT(is_valid(t));
    RC_ASSERT(insertion.has_flipped() == insertion.measures().empty());
    (*rc::gen::arbitrary<bool>() ? a : b) = static_cast<VertexId>(t.points.size() - 1);
  }
}

}  // namespace
}  // namespace pardel::engine
