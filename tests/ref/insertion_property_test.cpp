// The basis of all theorems on insertion: insertion gives a (constrained) Delaunay mesh (THEORY.md, Lemma 4).
#include <algorithm>
#include <map>

#include "../../properties/theorems/framework/property.hpp"
#include "../../properties/theorems/framework/shares.hpp"
#include "../../ref/insertion.hpp"

namespace pardel::ref {
namespace {

constexpr const char* lattice = "random points of a 9 x 9 lattice, many collinear, many cocircular";
constexpr const char* walled_lattice = "the same in a far box, where the first edge of every third triangle is a wall";

/// Distinct points of a small lattice.
std::vector<Point> lattice_points() {
  const auto coordinates = *rc::gen::resize(25, rc::gen::unique<std::vector<std::pair<int, int>>>(
                                                    rc::gen::pair(rc::gen::inRange(0, 9), rc::gen::inRange(0, 9))));
  std::vector<Point> points;
  for (const auto& [x, y] : coordinates) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  return points;
}

PlainMesh walled(const std::vector<Point>& points) {
  PlainMesh mesh = delaunay_in_far_box(points);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) mesh.constraints.insert(edge_of(mesh.triangles[t], 0));
  return mesh;
}

/// The scene that the picture shows, without walls that end at a corner of the far box.
properties::Scene scene_of(const std::vector<Point>& points, const PlainMesh& mesh, std::vector<Point> insertions) {
  properties::Scene scene{points, {}, std::move(insertions)};
  for (const Edge& e : mesh.constraints)
    if (e[1] < points.size()) scene.walls.push_back(e);
  return scene;
}

/// A random point that is not a lattice point.
Point half_lattice_point() { return {*rc::gen::inRange(0, 17) / 2.0, *rc::gen::inRange(0, 17) / 2.0 + 0.25}; }

/// The cavity, found by flood fill as in mesh generators: the search starts at the triangles that contain p, crosses
/// only edges that are not walls, and stops at triangles whose circumdisk does not contain p.
std::vector<Index> flooded_cavity(const PlainMesh& mesh, const ExactPoint& p) {
  std::map<Edge, std::vector<Index>> at;
  std::vector<Index> frontier;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const Corners& c = mesh.triangles[t];
    for (int i = 0; i < 3; ++i) at[edge_of(c, i)].push_back(t);
    if (!Kernel::Triangle_2(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]).has_on_unbounded_side(p))
      frontier.push_back(t);
  }
  std::set<Index> reached;
  while (!frontier.empty()) {
    const Index t = frontier.back();
    frontier.pop_back();
    if (!circumdisk_contains(mesh, mesh.triangles[t], p) || !reached.insert(t).second) continue;
    for (int i = 0; i < 3; ++i)
      if (const Edge e = edge_of(mesh.triangles[t], i); !mesh.constraints.contains(e))
        frontier.insert(frontier.end(), at[e].begin(), at[e].end());
  }
  return {reached.begin(), reached.end()};
}

PARDEL_PROPERTY(Insertion, of_one_point_after_the_other_makes_a_conformal_delaunay_mesh,
                {.statement = "Inserting points one after the other gives a mesh that is conformal and Delaunay by "
                              "definition. The number of triangles agrees with Euler's formula.",
                 .source = "Bowyer 1981, Watson 1981; [CC]",
                 .families = lattice}) {
  const std::vector<Point> points = lattice_points();
  const PlainMesh mesh = delaunay_in_far_box(points);
  exhibit.show(scene_of(points, mesh, {}));
  RC_ASSERT(is_delaunay(mesh));
  RC_ASSERT(is_conformal(mesh));
  RC_ASSERT(mesh.triangles.size() == 2 * points.size() + 2);  // n points inside a quadrilateral
}

PARDEL_PROPERTY(Insertion, order_does_not_matter_where_no_four_points_are_cocircular,
                {.statement = "If no four points are cocircular, every order of insertion gives the same mesh.",
                 .source = "the Delaunay triangulation is then unique",
                 .families = "points (x, x²), x > 0: no four of them lie on a circle"}) {
  auto abscissae = *rc::gen::resize(12, rc::gen::unique<std::vector<int>>(rc::gen::inRange(1, 40)));
  const auto triangulated = [&] {
    std::vector<Point> points;
    for (int x : abscissae) points.push_back({static_cast<double>(x), static_cast<double>(x) * x});
    const PlainMesh mesh = delaunay_in_far_box(points);
    exhibit.show(scene_of(points, mesh, {}));
    std::set<std::set<ExactPoint>> triangles;
    for (const Corners& t : mesh.triangles) triangles.insert({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
    return triangles;
  };
  const auto in_order = triangulated();
  std::ranges::sort(abscissae, std::greater<>());
  RC_ASSERT(triangulated() == in_order);
}

PARDEL_PROPERTY(
    Insertion, finds_the_same_cavity_by_definition_and_by_a_flood_fill,
    {.statement = "The cavity of p by definition (the triangles that p sees and whose open circumdisk contains p) is "
                  "the set that a flood fill from the triangle of p reaches across edges that are no walls.",
     .source = "THEORY.md, Lemma 3",
     .families = walled_lattice}) {
  const std::vector<Point> points = lattice_points();
  const PlainMesh mesh = walled(points);
  // p may be a lattice point, so that it often lies on circumcircles and walls.
  const Point p{*rc::gen::inRange(0, 17) / 2.0, *rc::gen::inRange(0, 17) / 2.0};
  RC_PRE(std::ranges::count(points, p) == 0);
  exhibit.show(scene_of(points, mesh, {p}));
  RC_ASSERT(cavity(mesh, exact(p)) == flooded_cavity(mesh, exact(p)));
}

/// The sum of the lengths of the projections of e onto the axes. It is exact, and additive along a wall.
Number length_of_projections(const PlainMesh& mesh, const Edge& e) {
  const Kernel::Vector_2 along = mesh.points[e[1]] - mesh.points[e[0]];
  return CGAL::abs(along.x()) + CGAL::abs(along.y());
}

PARDEL_PROPERTY(
    Insertion, keeps_a_constrained_delaunay_mesh_and_its_walls,
    {.statement = "Inserting points, also on walls, keeps a constrained Delaunay mesh conformal and constrained "
                  "Delaunay, and edges still cover the walls.",
     .source = "THEORY.md, Lemma 4",
     .families = walled_lattice}) {
  const std::vector<Point> points = lattice_points();
  PlainMesh mesh = walled(points);
  std::vector<Point> insertions = {half_lattice_point(), half_lattice_point(), half_lattice_point()};
  insertions.erase(std::unique(insertions.begin(), insertions.end()), insertions.end());
  exhibit.show(scene_of(points, mesh, insertions));
  Number before = 0, after = 0;
  for (const Edge& e : mesh.constraints) before += length_of_projections(mesh, e);
  const std::size_t pieces = mesh.constraints.size();

  for (const Point& p : insertions)
    if (std::ranges::count(mesh.points, exact(p)) == 0) insert(mesh, exact(p));

  properties::classify(mesh.constraints.size() > pieces, "a wall was split", 8);
  for (const Edge& e : mesh.constraints) after += length_of_projections(mesh, e);
  RC_ASSERT(is_conformal(mesh));
  RC_ASSERT(is_constrained_delaunay(mesh));
  RC_ASSERT(before == after);
  std::set<Edge> edges;
  for (const Corners& t : mesh.triangles) edges.insert({edge_of(t, 0), edge_of(t, 1), edge_of(t, 2)});
  RC_ASSERT(std::ranges::includes(edges, mesh.constraints));
}

}  // namespace
}  // namespace pardel::ref
