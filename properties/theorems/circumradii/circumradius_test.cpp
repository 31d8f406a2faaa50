// T2: inserting a point that does not encroach does not raise the largest circumradius. Proof: properties/THEORY.md, T2
// and Lemma 5.
#include <algorithm>
#include <cmath>

#include "../../../ref/insertion.hpp"
#include "../framework/on_walls.hpp"
#include "../framework/property.hpp"
#include "../framework/scene_carving.hpp"
#include "../framework/shares.hpp"
#include "left_triangle.hpp"

namespace pardel::properties {
namespace {
using generators::Random;
using ref::Number;

/// A new triangle abp on the edge ab of the boundary of the cavity of p.
struct Replacement {
  Index a, b;
  Number squared_radius;
  Number inside;                 ///< r² of the triangle of the cavity at ab
  std::optional<Number> beyond;  ///< r² of the triangle beyond ab; none if ab is constrained or on the hull
  bool encroaches;               ///< does p encroach upon ab?
  bool is_on_circle;             ///< does p lie on the diametral circle of ab?

  /// T2 says nothing about it: ab is constrained or on the hull, and p lies strictly inside its diametral circle.
  [[nodiscard]] bool is_excluded() const { return !beyond && encroaches && !is_on_circle; }
};

std::vector<Replacement> replacements(const ref::PlainMesh& mesh, const ref::ExactPoint& p) {
  ref::PlainMesh with_p = mesh;
  with_p.points.push_back(p);
  std::vector<Replacement> result;
  for (const ref::Corners& t :
       ref::retriangulation(with_p, ref::cavity(mesh, p), static_cast<Index>(mesh.points.size()))) {
    const bool is_constrained = mesh.constraints.contains(ref::edge(t[0], t[1]));
    result.push_back({t[0], t[1], squared_circumradius(with_p, t), *squared_circumradius_left_of(mesh, t[0], t[1]),
                      is_constrained ? std::nullopt : squared_circumradius_left_of(mesh, t[1], t[0]),
                      ref::encroaches(p, mesh.points[t[0]], mesh.points[t[1]]),
                      CGAL::angle(mesh.points[t[0]], p, mesh.points[t[1]]) == CGAL::RIGHT});
  }
  return result;
}

/// True if the point lies strictly inside the diametral circle of no constrained edge and no hull edge of the boundary
/// of its cavity. An edge that it splits is not counted.
bool encroaches_on_nothing(const std::vector<Replacement>& replacements) {
  return std::ranges::none_of(replacements, &Replacement::is_excluded);
}

/// Does the point lie on the diametral circle of a constrained edge or hull edge of the boundary of its cavity?
bool is_on_a_circle(const std::vector<Replacement>& replacements) {
  return std::ranges::any_of(replacements, [](const Replacement& r) { return !r.beyond && r.is_on_circle; });
}

struct Case {
  MeshedScene meshed;
  std::vector<ref::ExactPoint> points;  ///< insertions of the scene, midpoints of walls, points on diametral circles
};

/// The point on the diametral circle of an edge of the border, or of a wall, that is farthest from the edge, on its
/// left side. For an edge of the border this is the side of the mesh.
ref::ExactPoint above_an_edge(const MeshedScene& meshed) {
  std::vector<ref::Edge> edges = border_of(meshed.mesh);
  edges.insert(edges.end(), meshed.mesh.constraints.begin(), meshed.mesh.constraints.end());
  const ref::Edge e = *rc::gen::elementOf(edges).as("edge");
  const ref::ExactPoint &a = meshed.mesh.points[e[0]], &b = meshed.mesh.points[e[1]];
  const ref::Kernel::Vector_2 half = (b - a) / 2;
  return a + half + half.perpendicular(CGAL::COUNTERCLOCKWISE);
}

Case some_case(Exhibit& exhibit, const SceneSpec& spec) {
  Case result{*scenes(spec).as("scene"), {}};
  const Scene& scene = result.meshed.scene;
  exhibit.show(scene);
  tag_families(result.meshed);
  for (const Point& p : scene.insertions) result.points.push_back(ref::exact(p));
  if (!scene.walls.empty() && *rc::gen::arbitrary<bool>().as("also split a wall")) {
    const ref::Edge wall = *rc::gen::elementOf(scene.walls).as("wall");
    const ref::ExactPoint middle = CGAL::midpoint(ref::exact(scene.points[wall[0]]), ref::exact(scene.points[wall[1]]));
    if (std::ranges::count(result.points, middle) == 0) result.points.push_back(middle);
  }
  if (*rc::gen::arbitrary<bool>().as("also a point on a diametral circle")) {
    const ref::ExactPoint p = above_an_edge(result.meshed);
    const std::vector<ref::ExactPoint>& vertices = result.meshed.mesh.points;
    if (lies_in(result.meshed.mesh, p) && std::ranges::count(vertices, p) + std::ranges::count(result.points, p) == 0)
      result.points.insert(result.points.begin(), p);
  }
  return result;
}

constexpr const char* scene_kinds =
    "all layouts, walls, carved domains and positions of random scenes; points on edges, circumcircles and walls, and "
    "on "
    "diametral circles of walls and hull edges";

void every_new_radius_is_bounded_across_its_edge(Exhibit& exhibit, bool walls) {
  const SceneSpec spec{.insertions = 1, .on_walls = true, .mostly_on_walls = true};
  const Case given = some_case(exhibit, walls ? in_any_walled_domain(spec) : SceneSpec{.insertions = 1});
  if (walls) classify_outline(given.meshed, given.meshed.scene.insertions, 1);
  if (walls) classify_on_walls(given.meshed.mesh, given.points, {.two = 6});
  bool some_encroach = false, some_have_one_triangle = false, some_are_on_a_circle = false, some_are_equal = false;
  for (const ref::ExactPoint& p : given.points) {
    const std::vector<Replacement> all = replacements(given.meshed.mesh, p);
    some_are_on_a_circle |= is_on_a_circle(all);
    for (const Replacement& made : all) {
      some_encroach |= made.is_excluded();
      some_have_one_triangle |= !made.beyond && !made.is_excluded();
      if (made.beyond)
        RC_ASSERT(made.squared_radius <= std::max(made.inside, *made.beyond));
      else if (!made.is_excluded())
        RC_ASSERT(made.squared_radius < made.inside);
      some_are_equal |= made.beyond && made.squared_radius == std::max(made.inside, *made.beyond);
    }
  }
  classify(some_are_on_a_circle, "on the diametral circle of a constrained or hull edge", 20);
  classify(some_are_equal, "a new circumradius equals the larger of the two", 1.5);
  classify(some_encroach, "encroaches: no claim", 1);
  classify(some_have_one_triangle, "constrained or hull edge, not encroached", 1);
}

PARDEL_PROPERTY(
    T2, a_new_circumradius_is_at_most_the_larger_of_the_two_across_its_edge,
    {.statement = "Inserting p into a Delaunay mesh makes a triangle abp on each edge ab of the boundary "
                  "of its cavity. The circumradius of abp is at most the larger of the circumradii of "
                  "the two triangles that met at ab. If ab is on the hull and p is not strictly "
                  "inside its diametral circle, the circumradius is less than that of the old triangle at ab.",
     .source = "[CC]; THEORY.md, T2",
     .families = scene_kinds}) {
  every_new_radius_is_bounded_across_its_edge(exhibit, false);
}

PARDEL_PROPERTY(T2, a_new_circumradius_has_the_same_bound_in_a_constrained_mesh,
                {.statement = "Inserting p into a constrained Delaunay mesh makes a triangle abp on each edge ab of "
                              "the boundary of its cavity. The circumradius of abp is at most the larger of the "
                              "circumradii of the two triangles that met at ab. If ab is constrained or on the hull "
                              "and p is not strictly inside its diametral circle, the circumradius is less "
                              "than that of the old triangle on the side of p. p may split a constrained edge.",
                 .source = "THEORY.md, T2",
                 .families = scene_kinds}) {
  every_new_radius_is_bounded_across_its_edge(exhibit, true);
}

void the_bound_is_kept(Exhibit& exhibit, bool walls) {
  SceneSpec spec{.insertions = 2, .encroaching = false};
  if (walls) {
    spec = in_any_walled_domain(spec);
    spec.on_walls = spec.mostly_on_walls = true;
  }
  const Case given = some_case(exhibit, spec);
  // By Lemma 7, something is hidden only if a wall is encroached, so it is rare here.
  if (walls) classify_outline(given.meshed, given.meshed.scene.insertions, 0.3);
  ref::PlainMesh mesh = given.meshed.mesh;
  int inserted = 0;
  bool splits_inside = false, splits_border = false, is_on_circle = false;
  for (const ref::ExactPoint& p : given.points) {
    const std::vector<Replacement> made = replacements(mesh, p);
    if (!encroaches_on_nothing(made)) continue;
    is_on_circle |= is_on_a_circle(made);
    const SplitEdge split = split_edge_at(mesh, p);
    splits_inside |= split.is_wall && !split.is_border;
    splits_border |= split.is_border;
    ref::insert(mesh, p);
    ++inserted;
    RC_ASSERT(squared_circumradius_bound(mesh) <= given.meshed.squared_bound);
  }
  classify(inserted > 0, "something inserted", 90);
  classify(is_on_circle, "inserted on the diametral circle of a constrained or hull edge", 15);
  classify(splits_border, walls ? "a border edge was split" : "an edge of the hull was split", 10);
  if (walls) classify(splits_inside, "a wall inside the domain was split", 15);
}

PARDEL_PROPERTY(T2, inserting_points_that_encroach_on_no_hull_edge_of_their_cavities_keeps_the_circumradius_bound,
                {.statement = "Insert points into a Delaunay mesh one after the other. If no point lies "
                              "strictly inside the diametral circle of a hull edge of the boundary of its cavity, the "
                              "largest circumradius never grows.",
                 .source = "[CC]; THEORY.md, T2",
                 .families = scene_kinds}) {
  the_bound_is_kept(exhibit, false);
}

PARDEL_PROPERTY(
    T2, inserting_points_that_encroach_on_no_constrained_edge_of_their_cavities_keeps_the_circumradius_bound,
    {.statement = "Insert points into a constrained Delaunay mesh one after the other. If no point "
                  "lies strictly inside the diametral circle of a constrained edge or hull edge of the "
                  "boundary of its cavity, except an edge that it splits, the largest circumradius never grows.",
     .source = "THEORY.md, T2",
     .families = scene_kinds}) {
  the_bound_is_kept(exhibit, true);
}

/// Searches for a random scene in which inserting a point raises r̄. The point encroaches upon walls (if `walls` is
/// true) or only upon unconstrained hull edges. Returns the factor by which r̄ grows.
std::optional<double> growth_by_encroaching(bool walls, Facts& facts) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const MeshedScene given = random_scene(random, {.walls = walls, .insertions = 1});
    ++facts.cases;
    for (const Point& p : given.scene.insertions) {
      const std::vector<Replacement> made = replacements(given.mesh, ref::exact(p));
      const bool only_upon_this_kind = std::all_of(made.begin(), made.end(), [&](const Replacement& r) {
        return !r.is_excluded() || given.mesh.constraints.contains(ref::edge(r.a, r.b)) == walls;
      });
      ref::PlainMesh mesh = given.mesh;
      ref::insert(mesh, ref::exact(p));
      const Number growth = squared_circumradius_bound(mesh) / given.squared_bound;
      if (only_upon_this_kind && growth > 1) return std::sqrt(CGAL::to_double(growth));
    }
  }
  return std::nullopt;
}

PARDEL_FACT(T2, fails_for_points_that_encroach,
            {.statement = "T2 fails if the point encroaches upon a constrained edge of its cavity, or upon an "
                          "unconstrained edge of the hull.",
             .source = "THEORY.md, T2",
             .families = "random scenes with walls and without, until one is found"}) {
  for (const bool walls : {true, false}) {
    const std::optional<double> growth = growth_by_encroaching(walls, facts);
    ASSERT_TRUE(growth) << (walls ? "walls" : "hull");
    facts.notes.push_back(std::string("encroaching upon ") + (walls ? "a wall" : "the hull") +
                          ": the largest circumradius grew by a factor of " + std::to_string(*growth));
  }
}

}  // namespace
}  // namespace pardel::properties
