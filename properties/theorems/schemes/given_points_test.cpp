// Divide and conquer of given points by projected paths.
#include <CGAL/Gmpq.h>

#include <numeric>

#include "../../../ref/schemes/mesh/predicates.hpp"
#include "../../domains/domains.hpp"
#include "some_points.hpp"

namespace pardel::properties {
namespace {

using schemes::Account;
using schemes::Cut;
using schemes::Division;
using schemes::GivenPointsOptions;
using schemes::LinkedMesh;

Goal no_bounds() { return {.min_angle_deg = 0}; }

GivenPointsOptions some_options() {
  return {*rc::gen::element(schemes::CutOrder::alternating, schemes::CutOrder::longer_extent)};
}

/// The Delaunay triangulation by sequential insertion, with the tie rule.
LinkedMesh standard(const std::vector<Point>& points) {
  Pslg pslg;
  pslg.points = points;
  LinkedMesh mesh = required(schemes::triangulation_of(pslg)).mesh;
  schemes::settle_ties(mesh);
  return mesh;
}

/// A path of all points, at the line through the middle of two of them, which may be one point.
struct SomePath {
  std::vector<Point> points;
  Point m;
  Cut cut = Cut::x;
  std::vector<Index> path;
};
SomePath some_path(Exhibit& exhibit) {
  SomePath result{some_points(exhibit), {}, *rc::gen::element(Cut::x, Cut::y), {}};
  const auto any = [&] { return result.points[*rc::gen::inRange<std::size_t>(0, result.points.size())]; };
  const Point p = any(), q = any();
  result.m = {(p.x + q.x) / 2, (p.y + q.y) / 2};
  std::vector<Index> all(result.points.size());
  std::iota(all.begin(), all.end(), Index{0});
  result.path = schemes::dividing_path(result.points, all, result.m, result.cut);
  classify(result.path.size() > 2, "the path has an inner vertex", 50);
  return result;
}

/// Is there a point of the line of the cut from which a and b are equally far and no point is nearer? Exact.
bool lie_on_an_empty_circle(const SomePath& p, Index a, Index b) {
  using Number = CGAL::Gmpq;
  const auto exact = [&](Index v) {
    const Point t = schemes::turned(p.points[v], p.cut), m = schemes::turned(p.m, p.cut);
    return std::array{Number(t.x) - Number(m.x), Number(t.y) - Number(m.y)};
  };
  const auto [ax, ay] = exact(a);
  const auto [bx, by] = exact(b);
  if (ay == by) return false;
  const Number centre = (bx * bx + by * by - ax * ax - ay * ay) / (2 * (by - ay));
  const auto distance = [&](Index v) {
    const auto [x, y] = exact(v);
    return x * x + (y - centre) * (y - centre);
  };
  const Number radius = distance(a);
  for (Index v = 0; v < p.points.size(); ++v)
    if (distance(v) < radius) return false;
  return true;
}

PARDEL_PROPERTY(DividedPoints, neighbours_on_a_path_lie_on_an_empty_circle_around_a_point_of_the_line,
                {.statement = "The lower hull of the projections goes from the lowest to the highest point, and two "
                              "neighbours on it lie on a circle with its centre on the line that contains no point.",
                 .source = "Blelloch, Hardwick, Miller, Talmor 1999, Section 2",
                 .families = point_families}) {
  const SomePath p = some_path(exhibit);
  const auto height = [&](Index v) { return schemes::turned(p.points[v], p.cut).y; };
  const auto [low, high] = std::ranges::minmax(p.points, {}, [&](Point q) { return schemes::turned(q, p.cut).y; });
  RC_ASSERT(height(p.path.front()) == schemes::turned(low, p.cut).y);
  RC_ASSERT(height(p.path.back()) == schemes::turned(high, p.cut).y);
  for (std::size_t k = 1; k < p.path.size(); ++k) {
    RC_ASSERT(height(p.path[k - 1]) < height(p.path[k]));
    RC_ASSERT(lie_on_an_empty_circle(p, p.path[k - 1], p.path[k]));
  }
}

PARDEL_PROPERTY(DividedPoints, edges_of_a_path_are_delaunay_edges,
                {.statement = "Every edge of a path is an edge of the Delaunay triangulation in which each polygon of "
                              "cocircular points is a fan around its lexicographically smallest corner.",
                 .source = "Blelloch, Hardwick, Miller, Talmor 1999, Section 2",
                 .families = point_families}) {
  const SomePath p = some_path(exhibit);
  const LinkedMesh mesh = standard(p.points);
  const auto edges = edges_of(mesh);
  bool tie = false;
  for (Index t = 0; t < mesh.faces.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      if (mesh.faces[t].n[i] == no_index) continue;
      const schemes::Side twin = schemes::across(mesh, {t, i});
      const auto q = [&](int k) { return schemes::filtered(mesh.corner(t, k)); };
      tie = tie ||
            CGAL::side_of_oriented_circle(q(0), q(1), q(2), schemes::filtered(mesh.corner(twin.triangle, twin.i))) ==
                CGAL::ON_ORIENTED_BOUNDARY;
    }
  classify(tie, "four points are cocircular", 20);
  for (std::size_t k = 1; k < p.path.size(); ++k)
    RC_ASSERT(edges.contains({std::min(p.path[k - 1], p.path[k]), std::max(p.path[k - 1], p.path[k])}));
}

PARDEL_PROPERTY(DividedPoints, off_the_path_the_line_and_the_path_have_the_same_sides,
                {.statement = "A point that is not on the path lies on the same side of the path and of the line; all "
                              "points of the line are on the path.",
                 .source = "Blelloch, Hardwick, Miller, Talmor 1999, Section 2",
                 .families = point_families}) {
  const SomePath p = some_path(exhibit);
  const schemes::PathPlaces places(p.path);
  const auto at = [&](Index v) { return schemes::turned(p.points[v], p.cut); };
  const double line = schemes::turned(p.m, p.cut).x;
  bool crosses = false;
  for (std::size_t k = 1; k < p.path.size(); ++k) crosses |= (at(p.path[k - 1]).x < line) != (at(p.path[k]).x < line);
  classify(crosses, "the path changes sides of the line", 20);
  for (Index v = 0; v < p.points.size(); ++v) {
    if (places[v] != no_index) continue;
    RC_ASSERT(at(v).x != line);
    const bool left = at(v).x < line;
    for (std::size_t k = 1; k < p.path.size(); ++k) {
      const Point a = at(p.path[k - 1]), b = at(p.path[k]);
      if (at(v).y < a.y || at(v).y > b.y) continue;
      RC_ASSERT((schemes::orientation(a, b, at(v)) > 0) == left);
    }
  }
}

PARDEL_PROPERTY(DividedPoints, parts_have_every_inner_point_once_and_borders_from_both_sides,
                {.statement = "An edge of a border is an edge of the hull or the border of another part, in the other "
                              "direction; a point inside a part belongs to no other part; every point is in a part.",
                 .source = "Blelloch, Hardwick, Miller, Talmor 1999, Figure 4, step 5",
                 .families = point_families}) {
  const std::vector<Point> points = some_points(exhibit);
  Account account;
  const int workers = *rc::gen::resize(100, rc::gen::inRange(2, 40));
  const Division division = schemes::division_of(points, workers, some_options(), account);
  std::map<std::array<Index, 2>, int> directed;
  std::vector<int> parts(points.size(), 0), inner(points.size(), 0);
  for (const schemes::Part& part : division.parts) {
    for (const auto& edge : part.border) ++directed[edge];
    for (const Index v : part.points) ++parts[v];
    for (const Index v : schemes::inner_points(part)) ++inner[v];
  }
  classify(division.paths.size() > 3, "there are more than three cuts", 30);
  const auto hull = schemes::hull_of(points);
  for (const auto& edge : hull) RC_ASSERT(directed.contains(edge));
  for (const auto& [edge, times] : directed) {
    RC_ASSERT(times == 1);
    RC_ASSERT(directed.contains({edge[1], edge[0]}) == (std::ranges::find(hull, edge) == hull.end()));
  }
  for (std::size_t v = 0; v < points.size(); ++v) {
    RC_ASSERT(parts[v] >= 1);
    if (inner[v] > 0) RC_ASSERT(parts[v] == 1);
  }
}

PARDEL_PROPERTY(DividedPoints, parts_are_triangulated_only_inside_their_borders,
                {.statement = "The triangles of all parts are those of the Delaunay triangulation, each once.",
                 .source = "Blelloch, Hardwick, Miller, Talmor 1999, Section 4",
                 .families = point_families}) {
  const std::vector<Point> points = some_points(exhibit);
  Account account;
  const int workers = *rc::gen::resize(100, rc::gen::inRange(1, 80));
  const Division division = schemes::division_of(points, workers, some_options(), account);
  bool removed = false;
  std::size_t triangles = 0;
  for (const schemes::Part& part : division.parts) {
    if (part.points.empty()) continue;
    const schemes::PartTriangles of_part = schemes::triangles_of(points, part);
    removed = removed || of_part.held > of_part.triangles.size();
    triangles += of_part.triangles.size();
  }
  classify(removed, "a part has triangles outside its border", 40);
  RC_ASSERT(triangles == standard(points).faces.size());
}

PARDEL_PROPERTY(DividedPoints, triangulation_is_certified,
                {.statement = "The union of the parts is the Delaunay triangulation of all points: the checker "
                              "certifies it, and it has the triangles of sequential insertion up to ties.",
                 .source = "Blelloch, Hardwick, Miller, Talmor 1999, Section 2",
                 .families = scheme_families}) {
  SchemeCase c = some_scheme_case(exhibit);
  c.pslg.segments.clear();
  c.pslg.holes.clear();
  c.pslg.regions.clear();
  c.goal = no_bounds();
  c.workers = *rc::gen::resize(100, rc::gen::inRange(1, 40));
  const LinkedMesh mesh = required(schemes::triangulate_given_points(c.problem(), some_options())).mesh;
  certify(mesh, c, exhibit);
  classify(c.workers > 4, "more than four workers", 50);
  RC_ASSERT(placed_triangles(mesh) == placed_triangles(standard(c.pslg.points)));
}

PARDEL_PROPERTY(DividedPoints, triangulation_depends_on_the_points_only,
                {.statement = "The triangulation depends neither on the number of workers nor on the cuts nor on the "
                              "order of the points, also if points are cocircular.",
                 .source = "ref/schemes/given_points/path.hpp, tie rule",
                 .families = point_families}) {
  Pslg pslg;
  pslg.points = some_points(exhibit);
  const Goal goal = no_bounds();
  const int workers = *rc::gen::resize(100, rc::gen::inRange(1, 80));
  const GivenPointsOptions options = some_options();
  const auto by_one = required(schemes::triangulate_given_points({pslg, goal, 1}));
  const auto by_many = required(schemes::triangulate_given_points({pslg, goal, workers}, options));
  RC_ASSERT(placed_triangles(by_one.mesh) == placed_triangles(by_many.mesh));
  Pslg reversed = pslg;
  std::ranges::reverse(reversed.points);
  const auto in_reverse = required(schemes::triangulate_given_points({reversed, goal, workers}, options));
  RC_ASSERT(placed_triangles(by_one.mesh) == placed_triangles(in_reverse.mesh));
  classify(workers > 8, "more than eight workers", 50);
}

PARDEL_PROPERTY(DividedPoints, costs_are_those_of_hulls_and_parts,
                {.statement = "One worker reads each point once for the hull, its hull once more, and what sequential "
                              "insertion reads, and sends nothing. More workers wait three times per level and three "
                              "times besides; each level at most halves the largest team. Nothing is wasted.",
                 .source = "ref/schemes/given_points.hpp",
                 .families = point_families}) {
  Pslg pslg;
  pslg.points = some_points(exhibit);
  const Goal goal = no_bounds();
  const Account one = required(schemes::triangulate_given_points({pslg, goal, 1})).account;
  schemes::Part whole{{}, schemes::hull_of(pslg.points)};
  for (Index v = 0; v < pslg.points.size(); ++v) whole.points.push_back(v);
  const schemes::PartTriangles triangles = schemes::triangles_of(pslg.points, whole);
  RC_ASSERT(one.work == pslg.points.size() + whole.border.size() + triangles.work);
  RC_ASSERT(one.critical == one.work);
  RC_ASSERT(one.messages == 0U);
  RC_ASSERT(one.most_held == triangles.triangles.size());
  const int workers = *rc::gen::resize(100, rc::gen::inRange(1, 80));
  const Account many = required(schemes::triangulate_given_points({pslg, goal, workers}, some_options())).account;
  int levels = 0;
  while (1 << levels < workers) ++levels;
  classify(many.rounds > 2, "more than two levels", 30);
  RC_ASSERT(many.rounds <= static_cast<std::uint64_t>(levels));
  RC_ASSERT(many.barriers == 3 * many.rounds + 3);
  RC_ASSERT(many.wasted + many.sequential + many.set_backs + many.insertions == 0U);
  RC_ASSERT(many.critical * static_cast<std::uint64_t>(workers) >= many.work);
}

// Of four cocircular points, the neighbours in the order of y and those in the order of x include two pairs whose
// segments cross, though both lie on the same empty circle. Paths by the tie rule do not cross.
TEST(DividedPoints, without_a_tie_rule_two_paths_cross) {
  const std::vector<Point> points = {{-5, 0}, {4, 3}, {0, 5}, {3, -4}};
  const std::vector<Index> all = {0, 1, 2, 3};
  // In the order of y: 3, 0, 1, 2. In the order of x: 0, 2, 3, 1.
  const auto crosses = [&](Index a, Index b, Index c, Index d) {
    const auto side = [&](Index p, Index q, Index r) { return schemes::orientation(points[p], points[q], points[r]); };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
  };
  EXPECT_TRUE(crosses(0, 1, 2, 3));
  const std::vector<Index> up = schemes::dividing_path(points, all, points[2], Cut::x);
  const std::vector<Index> along = schemes::dividing_path(points, all, points[0], Cut::y);
  EXPECT_EQ(up, (std::vector<Index>{3, 0, 2}));
  for (std::size_t i = 1; i < up.size(); ++i)
    for (std::size_t j = 1; j < along.size(); ++j) EXPECT_FALSE(crosses(up[i - 1], up[i], along[j - 1], along[j]));
}

PARDEL_FACT(DividedPoints, a_worker_holds_its_share_of_random_points,
            {.statement = "Of n random points in a square, no worker holds more than 3 n / workers triangles.",
             .source = "Blelloch, Hardwick, Miller, Talmor 1999, Section 4",
             .families = "5,000 random points, 1 to 64 workers"}) {
  const Pslg pslg = domains::random_points(5000, 1);
  const Goal goal = no_bounds();
  for (int workers = 1; workers <= 64; workers *= 2, ++facts.cases) {
    const auto outcome = schemes::triangulate_given_points({pslg, goal, workers});
    ASSERT_TRUE(outcome);
    EXPECT_LE(outcome->account.most_held * static_cast<std::uint64_t>(workers), 3 * pslg.points.size()) << workers;
  }
}

}  // namespace
}  // namespace pardel::properties
