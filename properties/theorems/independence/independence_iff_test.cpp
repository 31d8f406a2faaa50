// T1-iff: the exact condition for the independence of points, at any distance.
#include <algorithm>
#include <set>

#include "../../../ref/independent.hpp"
#include "../../../ref/insertion.hpp"
#include "../framework/on_walls.hpp"
#include "../framework/property.hpp"
#include "../framework/scene_carving.hpp"
#include "../framework/shares.hpp"
#include "pairs.hpp"

namespace pardel::properties {
namespace {

constexpr const char* near_and_far =
    "pairs below 2.5 r̄ and at any distance; all layouts of points; hulls, hulls with walls, carved domains with "
    "holes; degenerate positions";

/// A scene with insertions at any distance. In half of the scenes each insertion is near an earlier one; in half of
/// them every second insertion lies on a wall.
MeshedScene at_any_distance(int insertions, int more) {
  SceneSpec spec = in_any_domain({.insertions = insertions, .more = more});
  const bool near = *rc::gen::arbitrary<bool>();
  spec.on_walls = true;
  spec.mostly_on_walls = *rc::gen::arbitrary<bool>().as("many insertions on walls");
  if (near) spec.most = 2.5;
  return *scenes(spec);
}

/// The edges on the boundaries of both cavities, directed with the cavity of p on the left.
std::vector<ref::Edge> common_edges(const ref::PlainMesh& mesh, const ref::ExactPoint& p, const ref::ExactPoint& q) {
  std::vector<ref::Edge> common = ref::boundary(mesh, ref::cavity(mesh, p));
  const std::vector<ref::Edge> of_q = ref::boundary(mesh, ref::cavity(mesh, q));
  std::erase_if(common, [&](const ref::Edge& e) { return std::ranges::count(of_q, ref::Edge{e[1], e[0]}) == 0; });
  return common;
}

/// The position of p relative to the circle through q, m and n.
CGAL::Bounded_side side(const ref::PlainMesh& mesh, const ref::ExactPoint& p, const ref::ExactPoint& q,
                        const ref::Edge& mn) {
  return CGAL::side_of_bounded_circle(q, mesh.points[mn[0]], mesh.points[mn[1]], p);
}

/// The constrained edges as a set that does not depend on the numbering of vertices.
std::set<std::set<ref::ExactPoint>> constraints_as_points(const ref::PlainMesh& mesh) {
  std::set<std::set<ref::ExactPoint>> edges;
  for (const ref::Edge& e : mesh.constraints) edges.insert({mesh.points[e[0]], mesh.points[e[1]]});
  return edges;
}

/// Tags the case with the way in which the cavities meet. The shares of the tags in the catalogue show that both
/// directions of the equivalence are tested.
void tag_contact(const MeshedScene& scene, const ref::ExactPoint& p, const ref::ExactPoint& q) {
  const Contact meet = contact(scene.mesh, p, q);
  RC_TAG(name(meet));
  classify(ref::are_independent(scene.mesh, p, q), "independent", 40);
  bool wall_inside = false, inside = false, on = false, outside = false;
  for (const ref::Edge& e : meet == Contact::edge ? common_edges(scene.mesh, p, q) : std::vector<ref::Edge>()) {
    const bool wall = scene.mesh.constraints.contains(ref::edge(e[0], e[1]));
    const CGAL::Bounded_side where = side(scene.mesh, p, q, e);
    wall_inside |= wall && where == CGAL::ON_BOUNDED_SIDE;
    inside |= !wall && where == CGAL::ON_BOUNDED_SIDE;
    on |= !wall && where == CGAL::ON_BOUNDARY;
    outside |= !wall && where == CGAL::ON_UNBOUNDED_SIDE;
  }
  classify(wall_inside, "a wall between: inside the circle", 0.1);
  classify(inside, "a common edge: inside the circle", 1);
  classify(on, "a common edge: on the circle", 0.5);
  classify(outside, "a common edge: outside of the circle", 2);
}

PARDEL_PROPERTY(
    T1Iff, two_points_are_independent_iff_no_triangle_is_common_and_common_edges_stay_locally_delaunay,
    {.statement = "Let p and q be distinct points of a constrained Delaunay mesh, and not vertices. These are "
                  "equivalent: (a) their cavities have no triangle in common, and for no unconstrained edge mn on both "
                  "boundaries is p strictly inside the circumcircle of q, m and n; (b) inserting them independently "
                  "gives a conformal constrained Delaunay mesh; (c) it gives the mesh of both sequential orders. "
                  "Cocircular points are independent. Constrained edges are not tested.",
     .source = "properties/THEORY.md, T1-iff",
     .families = near_and_far}) {
  const MeshedScene scene = at_any_distance(2, 0);
  exhibit.show(scene.scene);
  tag_families(scene);
  classify_outline(scene, scene.scene.insertions, 1);
  const auto points = insertions_of(scene.scene);
  tag_contact(scene, points[0], points[1]);
  classify_on_walls(scene.mesh, points, {.two = 6});
  const bool independent = ref::are_independent(scene.mesh, points[0], points[1]);
  const Outcomes made = outcomes(scene.mesh, points);
  RC_ASSERT(is_conformal_and_delaunay(made.at_once) == independent);
  RC_ASSERT(made.are_one_mesh() == independent);
}

PARDEL_PROPERTY(
    T1Iff, independence_is_symmetric,
    {.statement = "The conditions of T1-iff and T1-closures are symmetric in p and q. Independent insertion "
                  "gives the same triangles and constrained edges in either order, also if p and q are "
                  "not independent.",
     .source = "properties/THEORY.md, T1-iff; ref/independent.hpp",
     .families = near_and_far}) {
  const MeshedScene scene = at_any_distance(2, 0);
  exhibit.show(scene.scene);
  const auto points = insertions_of(scene.scene);
  const ref::ExactPoint &p = points[0], &q = points[1];
  RC_TAG(name(contact(scene.mesh, p, q)));
  RC_ASSERT(ref::are_independent(scene.mesh, p, q) == ref::are_independent(scene.mesh, q, p));
  RC_ASSERT(ref::closures_are_disjoint(scene.mesh, p, q) == ref::closures_are_disjoint(scene.mesh, q, p));
  const ref::PlainMesh made = ref::insert_independently(scene.mesh, {p, q});
  const ref::PlainMesh in_reverse = ref::insert_independently(scene.mesh, {q, p});
  RC_ASSERT(ref::triangles_as_points(made) == ref::triangles_as_points(in_reverse));
  RC_ASSERT(made.triangles.size() == in_reverse.triangles.size());
  RC_ASSERT(constraints_as_points(made) == constraints_as_points(in_reverse));
}

PARDEL_PROPERTY(T1Iff, a_set_of_points_is_independent_iff_every_two_of_them_are,
                {.statement = "Let points of a constrained Delaunay mesh be distinct and not vertices. These are "
                              "equivalent: every two of the points are independent; inserting all of them "
                              "independently gives a conformal constrained Delaunay mesh; it gives the mesh of "
                              "sequential insertion.",
                 .source = "properties/THEORY.md, T1-iff",
                 .families = "three to five points, each closer than 2.5 r̄ to an earlier one or at any distance; all "
                             "layouts, walls, positions"}) {
  const MeshedScene scene = at_any_distance(3, 2);
  exhibit.show(scene.scene);
  tag_families(scene);
  classify_outline(scene, scene.scene.insertions, 1);
  const auto points = insertions_of(scene.scene);
  classify_on_walls(scene.mesh, points, {.two = 6});
  const bool independent = are_pairwise_independent(scene.mesh, points);
  classify(independent, "independent", 8);
  const Outcomes made = outcomes(scene.mesh, points);
  RC_ASSERT(is_conformal_and_delaunay(made.at_once) == independent);
  RC_ASSERT(made.are_one_mesh() == independent);
}

}  // namespace
}  // namespace pardel::properties
